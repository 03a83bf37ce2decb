open Scc_codec
open Scc_graph_search

(* Written in pieces. *)
let enough = 1 lsl 20
let mark = "scc shard 2\n"

type file = { channel : out_channel; buffer : Buffer.t }

let drain f =
  Buffer.output_buffer f.channel f.buffer;
  Buffer.clear f.buffer

let put_level f part levels records level =
  let from = Levels.start levels level and stop = Levels.start levels (level + 1) in
  Packed.put_nat f.buffer (stop - from);
  let near = Tuples.spread (Part.table part) in
  for id = from to stop - 1 do
    let way = Part.way part id in
    Packed.put_nat f.buffer way.sender;
    Packed.put_nat f.buffer (Levels.rank levels id);
    Tuples.load (Part.table part) near id;
    let instant = Part.instant part id in
    Records.put records ~time:0 ~instant ~before:way.before ~choice:way.choice (Tuples.slots near);
    Buffer.add_string f.buffer (Records.take records);
    if Buffer.length f.buffer > enough then drain f
  done

let write path part levels (progress : Progress.t) ~from =
  let f = { channel = open_out_bin path; buffer = Buffer.create (2 * enough) } in
  Fun.protect
    ~finally:(fun () -> close_out_noerr f.channel)
    (fun () ->
       Buffer.add_string f.buffer mark;
       Packed.put_nat f.buffer from;
       Progress.put f.buffer progress;
       Packed.put_list f.buffer Packed.put_nat (List.sort Int.compare (Part.turning part));
       let records = Records.make part in
       for level = from to Levels.count levels - 1 do put_level f part levels records level done;
       drain f;
       close_out f.channel)

let read_file path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in_noerr channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let malformed what = raise (Packed.Malformed what)

let read_level source part levels records =
  let count = Packed.nat source in
  let one _ =
    let sender = Packed.nat source in
    let rank = Packed.nat source in
    let before = Part.size part in
    ignore (Records.read_one records part ~sender source);
    if Part.size part = before then malformed "a state is there twice";
    rank
  in
  Levels.add levels (Array.init count one)

let read path part levels =
  match
    let text = read_file path in
    let n = String.length mark in
    if String.length text < n || not (String.equal (String.sub text 0 n) mark) then malformed "it is none";
    let source = Packed.source ~from:n text in
    if Packed.nat source <> Levels.count levels then malformed "it does not follow the one before";
    let progress = Progress.read source in
    let turning = Packed.list source Packed.nat in
    let records = Records.make part in
    while not (Packed.at_end source) do read_level source part levels records done;
    Part.close part;
    if List.exists (fun id -> id >= Part.size part) turning then malformed "it names a state that is not there";
    List.iter (Part.turns_at part) turning;
    ignore (Part.hits part : Part.hit list);
    if Levels.count levels <> progress.level + 1 then malformed "it has another number of levels";
    progress
  with
  | progress -> progress
  | exception (Packed.Malformed what | Failure what | Invalid_argument what | Sys_error what) ->
    Failure.refused "%s is no shard of this exploration: %s" path what
