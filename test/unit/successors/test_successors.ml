(* The filter of successors: bytes and back, fingerprints step by step, and whatever comes in. *)

open Scc_state_space
open Scc_loading
open Scc_successors

let folder = "../../../specs/models"

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let read_file name =
  match read (Filename.concat folder name) with
  | text -> Ok text
  | exception Sys_error what -> Error what

let load name =
  match Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name (read (Filename.concat folder name))) with
  | Ok l -> l
  | Error _ -> Alcotest.failf "%s is not loaded" name

let question ?(reductions = Question.reductions) ?(names = []) ?(number = 1) l =
  match Question.make ~reductions ~bits:100_000 ~names ~number l with
  | Ok q -> q
  | Error _ -> Alcotest.fail "there is no such question"

let names = [ "association.sc"; "chain.sc"; "clasp.sc"; "enzymes.sc"; "raft.sc"; "relay.sc"; "tumbling.sc" ]
let limit = 120

(* The first states of a model, with the filter's answers. *)
let explore f =
  let keys = Filter.keys f in
  let seen = Hashtbl.create 64 and work = Queue.create () and found = ref [] in
  let enter (r : Filter.reached) =
    let hex = Keys.hex r.fingerprint in
    if not (Hashtbl.mem seen hex) then begin
      Hashtbl.replace seen hex (Keys.bytes keys r.tuple);
      Queue.push r work
    end
    else Alcotest.(check string) "one state for a fingerprint" (Hashtbl.find seen hex) (Keys.bytes keys r.tuple)
  in
  enter (Filter.initial f);
  while (not (Queue.is_empty work)) && List.length !found < limit do
    let r = Queue.pop work in
    match Filter.expand f r.tuple with
    | Error d -> Alcotest.failf "a state is refused: %s" d.message
    | Ok e ->
      found := (r, e) :: !found;
      (match e.follows with
       | Moves moves -> List.iter (fun (_, r) -> enter r) moves
       | Rests | Ends _ | Stops | Fault _ -> ())
  done;
  List.rev !found

let bytes_of (r : Filter.reached) f = Keys.bytes (Filter.keys f) r.tuple
let whole text = (0, String.length text)

(* There and back in a filter that has seen nothing. *)
let same_elsewhere name () =
  let q = question (load name) in
  let f = Filter.make q and other = Filter.make q in
  let has_events = Filter.events f <> [] in
  let codec = Scc_codec.State_codec.make q.loaded.model q.initial in
  let one ((r : Filter.reached), (e : Filter.expanded)) =
    let text = bytes_of r f in
    let from, stop = whole text in
    match Filter.read other text ~from ~stop with
    | Error d -> Alcotest.failf "it is not read: %s" d.message
    | Ok tuple ->
      Alcotest.(check string) "the same bytes" text (Keys.bytes (Filter.keys other) tuple);
      Alcotest.(check string) "the same fingerprint" (Keys.hex r.fingerprint)
        (Keys.hex (Keys.fingerprint (Filter.keys other) tuple));
      Alcotest.(check string) "as of a state that nothing led to" (Keys.hex r.fingerprint)
        (Keys.hex e.state.fingerprint);
      if not has_events then
        Alcotest.(check string) "as the codec writes it" text
          (Catalogue.decode (Network_lts.catalogue (Filter.context f)) r.tuple
           |> Scc_codec.State_codec.encode codec);
      let answer f tuple =
        match Filter.expand f tuple with
        | Ok e -> Told.line (Answer (f, e))
        | Error d -> d.message
      in
      Alcotest.(check string) "the same answer" (answer f r.tuple) (answer other tuple)
  in
  let states = explore f in
  Alcotest.(check bool) "there are states" true (List.length states > 1);
  List.iter one states

let number n = String.init 4 (fun i -> Char.chr ((n lsr (8 * i)) land 255))

let rec frames text from =
  if from >= String.length text then []
  else
    let size = Int32.to_int (String.get_int32_le text from) in
    String.sub text (from + 4) size :: frames text (from + 4 + size)

(* Whatever bytes come in, as a state or as a batch: an answer, and no exception. *)
let damaged =
  let samples =
    lazy
      (let of_model name =
         let f = Filter.make (question (load name)) in
         List.map (fun (r, _) -> (f, Batch.make f, bytes_of r f)) (explore f)
       in
       Array.of_list (List.concat_map of_model names))
  in
  QCheck2.Test.make ~name:"damaged bytes" ~count:3000 ~print:string_of_int QCheck2.Gen.int (fun seed ->
      let rand = Random.State.make [| seed |] in
      let any = Random.State.int rand in
      let samples = Lazy.force samples in
      let f, batches, text = samples.(any (Array.length samples)) in
      let bytes = Bytes.of_string text in
      for _ = 0 to any 3 do
        Bytes.set bytes (any (Bytes.length bytes)) (Char.chr (if any 2 = 0 then any 256 else any 12))
      done;
      let length = if any 4 = 0 then any (Bytes.length bytes) else Bytes.length bytes in
      let changed = Bytes.sub_string bytes 0 length in
      let from, stop = whole changed in
      let told =
        match Filter.read f changed ~from ~stop with
        | Error d -> d.message <> ""
        | Ok tuple -> (
            String.equal (Keys.bytes (Filter.keys f) tuple) changed
            &&
            match Filter.expand f tuple with
            | Ok e -> Told.line (Answer (f, e)) <> ""
            | Error d -> d.message <> "")
      in
      let frame = number 1 ^ number 1 ^ number (String.length changed) ^ changed in
      let out = Buffer.create 64 in
      let good = Batch.answer batches frame out in
      let bad = Batch.answer batches (String.sub frame 0 (any (String.length frame))) (Buffer.create 64) in
      told && Result.is_ok good && List.length (frames (Buffer.contents out) 0) = 2 && Result.is_error bad)

(* With an empty memory: the same answers, and numbers of labels that mean what they meant. *)
let renewed () =
  let f = Filter.make (question (load "enzymes.sc")) in
  let states = explore f in
  let label f i = Told.of_moves (Filter.question f).loaded.model [ Filter.label f i ] [] in
  let labels f = List.init (Filter.labels f) (label f) in
  let before = labels f in
  let other = Filter.renew ~most:0 f in
  Alcotest.(check bool) "it is another one" true (other != f);
  Alcotest.(check bool) "and the same while it is small" true (Filter.renew other == other);
  let one ((r : Filter.reached), (e : Filter.expanded)) =
    let text = bytes_of r f in
    let from, stop = whole text in
    match Result.bind (Filter.read other text ~from ~stop) (Filter.expand other) with
    | Error d -> Alcotest.failf "it is not read: %s" d.message
    | Ok again ->
      Alcotest.(check string) "the same answer"
        (Told.line (Answer (f, e)))
        (Told.line (Answer (other, again)))
  in
  List.iter one states;
  Alcotest.(check (list string)) "the same labels" before (labels other)

(* {1 What has been told} *)

(* Few different words, so that many fingerprints have some in common, and all hashes are the same few. *)
let table =
  let name = "fingerprints as in a hash table" in
  QCheck2.Test.make ~name ~count:60 ~print:string_of_int QCheck2.Gen.int (fun seed ->
      let rand = Random.State.make [| seed |] in
      let any = Random.State.int rand in
      let words = [| 0; 1; 255; 0x7FFF_FFFF; 0x8000_0000; 0xFFFF_FFFF; any 0x3FFF_FFFF; any 0x3FFF_FFFF |] in
      let print () = Array.init Keys.words (fun _ -> words.(any 8)) in
      let prints = Prints.create () and model = Hashtbl.create 64 in
      let number p =
        match Hashtbl.find_opt model p with
        | Some n -> n
        | None ->
          let n = Hashtbl.length model in
          Hashtbl.replace model p n;
          n
      in
      let step () =
        if any 300 = 0 then begin
          let size = any (1 + Prints.size prints) in
          Prints.cut prints size;
          Hashtbl.filter_map_inplace (fun _ n -> if n < size then Some n else None) model;
          true
        end
        else
          let p = print () in
          let n = number p in
          Prints.intern prints p = n && Prints.size prints = Hashtbl.length model
      in
      List.for_all Fun.id (List.init 2000 (fun _ -> step ())))

let many_prints () =
  let prints = Prints.create () and count = 50_000 in
  let factors = [| 0x9E3779B1; 0x85EBCA77; 0xC2B2AE3D; 0x27D4EB2F |] in
  let print i = Array.map (fun k -> (i * k) land 0xFFFF_FFFF) factors in
  let put n = for i = 0 to n - 1 do assert (Prints.intern prints (print i) = i) done in
  put count;
  Prints.cut prints 30_000;
  Alcotest.(check int) "those before are there" 30_000 (Prints.size prints);
  put count;
  Alcotest.(check bool) "it is compact" true (Prints.bytes prints < 40 * count);
  Prints.cut prints 0;
  Alcotest.(check int) "none" 0 (Prints.intern prints (print 7))


let request kind numbers data =
  String.concat "" (List.map number (kind :: List.length numbers :: numbers)) ^ data

let asked batches kind numbers data =
  let out = Buffer.create 64 in
  match Batch.answer batches (request kind numbers data) out with
  | Ok () -> frames (Buffer.contents out) 0
  | Error d -> Alcotest.failf "%s" d.message

let at frame k = Int32.to_int (String.get_int32_le frame (4 * k)) land 0xFFFF_FFFF
let count_of home = at home 0
let prints_of home = String.sub home 12 (16 * count_of home)

(* What is told once is not told again, but for what is forgotten: since the mark, or all. *)
let told_again () =
  let f = Filter.make (question (load "enzymes.sc")) in
  let batches = Batch.make f in
  let texts = List.map (fun (r, _) -> bytes_of r f) (explore f) in
  let some = List.filteri (fun i _ -> i < 8) texts in
  let news homes texts =
    let lengths = List.map String.length texts in
    List.tl (asked batches 4 (homes :: lengths) (String.concat "" texts))
  in
  let keep how = at (List.hd (asked batches 6 [ how ] "")) 0 in
  let first = news 1 some in
  let told = List.hd first in
  Alcotest.(check bool) "something is told" true (count_of told > 4);
  Alcotest.(check int) "and not again" 0 (count_of (List.hd (news 1 some)));
  Alcotest.(check int) "nothing is kept" 0 (keep 1);
  Alcotest.(check (list string)) "the same is told again" first (news 1 some);
  Alcotest.(check int) "it is kept" (count_of told) (keep 0);
  let more = List.hd (news 1 texts) in
  Alcotest.(check bool) "more is told" true (count_of more > 0);
  Alcotest.(check int) "what was told before the mark stays" (count_of told) (keep 1);
  Alcotest.(check string) "the same is told again" more (List.hd (news 1 texts));
  let met = List.hd (asked batches 5 [] (prints_of told ^ prints_of more ^ prints_of more)) in
  let n = count_of told and m = count_of more in
  let expected = List.init n (fun _ -> 0) @ List.init m (fun i -> i + 1) @ List.init m (fun i -> i + 1) in
  Alcotest.(check (list int)) "from before the mark, and since then" expected
    (List.init (n + m + m) (fun i -> at met (i + 1)));
  Alcotest.(check int) "all is forgotten" 0 (keep 2);
  let homes = news 3 some in
  Alcotest.(check int) "three homes" 3 (List.length homes);
  Alcotest.(check int) "with the same among them" n (List.fold_left (fun sum h -> sum + count_of h) 0 homes);
  List.iteri
    (fun home h ->
       for k = 0 to count_of h - 1 do
         Alcotest.(check int) "each at its home" home (at h (3 + (4 * k)) mod 3)
       done)
    homes;
  let lost kind numbers data =
    Alcotest.(check bool) "it is refused" true
      (Result.is_error (Batch.answer batches (request kind numbers data) (Buffer.create 64)))
  in
  lost 4 [] "";
  lost 4 [ 0 ] "";
  lost 4 [ 1 lsl 20 ] "";
  lost 5 [] "abc";
  lost 5 [ 1 ] "";
  lost 6 [] "";
  lost 6 [ 3 ] "";
  lost 6 [ 0 ] "a"

let properties () =
  let l = load "raft.sc" in
  (match Question.make ~reductions:Question.reductions ~bits:100 ~names:[ "nobody" ] ~number:1 l with
   | Ok _ -> Alcotest.fail "a property that is not there"
   | Error d -> Alcotest.(check string) "code" "SC0922" ((List.hd d).code :> string));
  let all = question l in
  let rest = List.init all.count (fun k -> question ~number:(k + 1) l) in
  let members = List.concat_map (fun (q : Question.t) -> List.map fst q.plans) rest in
  Alcotest.(check int) "each property is in one exploration"
    (List.length (l.checks @ l.premises))
    (List.length members)

let () =
  let test name = Alcotest.test_case name `Quick (same_elsewhere name) in
  Alcotest.run "successors for programs"
    [
      ("bytes and fingerprints", List.map test names);
      ("whatever comes in", [ Scc_test_support.Property.case damaged ]);
      ("an empty memory", [ Alcotest.test_case "renewed" `Quick renewed ]);
      ( "what has been told",
        [
          Scc_test_support.Property.case table;
          Alcotest.test_case "many fingerprints" `Quick many_prints;
          Alcotest.test_case "told again" `Quick told_again;
        ] );
      ("questions", [ Alcotest.test_case "by name and number" `Quick properties ]);
    ]
