open Scc_base
open Scc_verdicts
open Scc_state_space
open Scc_successors
open Cmdliner

type framing = Lines | Batches

let framings = [ ("lines", Lines); ("batches", Batches) ]
let name framing = fst (List.find (fun (_, f) -> f = framing) framings)

(* {1 Lines} *)

(* A state is some hundred bytes long, and a large one some thousand. *)
let most_line = 1 lsl 26

let digit c =
  match c with
  | '0' .. '9' -> Some (Char.code c - Char.code '0')
  | 'a' .. 'f' -> Some (Char.code c - Char.code 'a' + 10)
  | _ -> None

let no_state fmt = Printf.ksprintf (fun text -> Error (Diag.error Code.no_state Span.none "%s" text)) fmt

let of_hex line =
  let n = String.length line in
  let byte i =
    match (digit line.[2 * i], digit line.[(2 * i) + 1]) with
    | Some high, Some low -> Char.chr ((16 * high) + low)
    | _ -> raise Exit
  in
  if n mod 2 = 1 then no_state "a state is written in pairs of digits, and here are %d digits" n
  else
    match String.init (n / 2) byte with
    | bytes -> Ok bytes
    | exception Exit -> no_state "a state is written in the digits 0 to 9 and a to f"

let state f line =
  let* bytes = of_hex line in
  let* tuple = Filter.read f bytes ~from:0 ~stop:(String.length bytes) in
  let* e = Filter.expand f tuple in
  Ok (Told.Answer (f, e))

(* Schedules are replayed with jumps. *)
let run path f line =
  let q = Filter.question f in
  if not (List.exists (Reduction.equal Jump) q.reductions) then
    Error (Diag.error Code.no_run Span.none "a run is one with jumps, and --no-reduce jump makes none")
  else
    let* request = Found_run.request line in
    match request with
    | Goal (goal, choices) ->
      let* check, witness = Found_run.find f ~goal choices in
      Ok (Told.Run (check, Scheduled.of_witness q.loaded path check witness))
    | Cycle (from, choices) ->
      let* witness = Found_run.cycle f ~from choices in
      let from = match witness.finish with Repeats { cycle; _ } -> cycle | _ -> from in
      Ok (Told.Cycle (from, Scheduled.of_run q.loaded path witness))

let answer path f line =
  let is_run = String.length line > 0 && line.[0] = '{' in
  Result.fold ~ok:Fun.id ~error:(fun d -> Told.Refused d) (if is_run then run path f line else state f line)

let talk_in_lines path f c =
  let lines = Lines.make ~most:most_line in
  let wait () = Conversation.send c in
  let rec loop f =
    match Lines.next lines ~wait with
    | End -> Exit_code.Holds
    | Too_long ->
      let d = Diag.error Code.no_state Span.none "a line of more than %d bytes" most_line in
      Conversation.say c (Told.line (Refused d));
      loop f
    | Line line ->
      Conversation.say c (Told.line (answer path f line));
      loop (Filter.renew f)
  in
  loop f

(* {1 Batches} *)

exception Lost of Diag.t

let lost fmt = Printf.ksprintf (fun text -> raise (Lost (Diag.error Code.lost_frame Span.none "%s" text))) fmt

let rec read bytes from stop =
  if from = stop then from
  else
    match Scc_system.Reading.input bytes from (stop - from) with
    | 0 -> from
    | n -> read bytes (from + n) stop

(* [None] where the input ends between two frames. *)
let next_frame () =
  let head = Bytes.create 4 in
  match read head 0 4 with
  | 0 -> None
  | 4 ->
    let size = Int32.to_int (Bytes.get_int32_le head 0) land 0xFFFF_FFFF in
    if size > Batch.most then lost "a batch of %d bytes: %d is the most" size Batch.most;
    let frame = Bytes.create size in
    if read frame 0 size < size then lost "the input ends within a batch";
    Some (Bytes.unsafe_to_string frame)
  | _ -> lost "the input ends within a batch"

let talk_in_batches console f c =
  let batches = Batch.make f in
  let rec loop () =
    Conversation.send c;
    match next_frame () with
    | None -> Exit_code.Holds
    | Some frame -> (
        match Conversation.add c (Batch.answer batches frame) with
        | Ok () -> loop ()
        | Error d -> raise (Lost d))
  in
  match loop () with
  | code -> code
  | exception Lost d ->
    Console.report console [ d ];
    Exit_code.Invalid

(* {1 The command} *)

type options = {
  names : string list;
  number : int;
  reductions : Reduction.kind list;
  bits : int;
  framing : framing;
  owner : Owner_mode.t option;
}

let headed ?owner framing filter = Told.line (Header { program = Version.told; framing; owner; filter })

let own console (o : Owner_mode.t) f =
  let* listener = Owner_mode.listen o.address in
  let { Scc_owners.Owner.number; count } = o.place in
  let owner = { Told.number = number + 1; count; port = Owner_mode.port listener } in
  Scc_system.Standard.print (headed ~owner "owner" f ^ "\n");
  Scc_system.Standard.flush ();
  Owner_mode.run console o f ~listener ~identity:(headed "owner" f)

let talk console options (given : Options.definitions) path =
  let* l = Input.model console ~overrides:given.values ~narrowed:given.narrowed path in
  Console.report console l.warnings;
  let reductions = List.filter (fun k -> List.exists (Reduction.equal k) options.reductions) Question.reductions in
  let* q = Question.make ~reductions ~bits:options.bits ~names:options.names ~number:options.number l in
  let f = Filter.make q in
  let hold c =
    Conversation.say c (headed (name options.framing) f);
    Conversation.send c;
    match options.framing with Lines -> talk_in_lines path f c | Batches -> talk_in_batches console f c
  in
  match options.owner with Some o -> own console o f | None -> Ok (Conversation.hold hold)

let run color options given path =
  if String.equal path "-" then Guard.usage "the model cannot be read from standard input, which is for states"
  else
    let console = Console.make ~color ~json:false () in
    Guard.run console (fun () -> talk console options given path)

let names =
  Options.repeated Arg.string [ "check" ] ~docv:"NAME"
    "Serves only the property $(docv), as if the model had no others. Repeatable. By default all properties are \
     served."

let number =
  let doc =
    "Properties with the same needs are explored together, and others separately, as in $(b,scc check). The \
     filter serves the exploration $(docv) of them. The first line of the output has their number."
  in
  let number = Options.integer ~least:1 ~most:1_000_000 "number of an exploration" in
  Arg.(value & opt number 1 & info [ "exploration" ] ~docv:"N" ~doc)

let framing =
  Options.default (Arg.enum framings) Lines [ "framing" ] ~docv:"HOW"
    "The form of states and answers: $(b,lines), a text for each, or $(b,batches), columns of numbers for many \
     at once."

let options =
  let make names number reductions bits framing owner =
    { names; number; reductions; bits = Option.value bits ~default:100_000; framing; owner }
  in
  Term.(const make $ names $ number $ Check_extras.reductions $ Check_options.bits $ framing $ Owner_mode.term)

let command =
  let exits =
    Exits.man () ~never:[ Violated; Undecided ]
      ~told:
        [
          (Holds, "at the end of the input; of an owner, before it has begun or after all is found.");
          (Invalid, "if the model is invalid, or a batch does not fit its format.");
          (Stopped, "if an interruption ended it, or the reader of its answers has ended.");
        ]
  in
  Cmd.v
    (Cmd.info "successors" ~doc:"answer states of other programs with their successors" ~man:Manual.successors
       ~exits)
    Term.(const run $ Options.color $ options $ Options.definitions $ Options.model_file)
