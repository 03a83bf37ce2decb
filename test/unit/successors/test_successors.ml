(* The filter of successors: bytes and back, fingerprints step by step, and whatever comes in. *)

open Scc_space
open Scc_session
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
        | Ok e -> Scc_exchange.Json.line (Told.answer f e)
        | Error d -> d.message
      in
      Alcotest.(check string) "the same answer" (answer f r.tuple) (answer other tuple)
  in
  let states = explore f in
  Alcotest.(check bool) "there are states" true (List.length states > 1);
  List.iter one states

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
            | Ok e -> Scc_exchange.Json.line (Told.answer f e) <> ""
            | Error d -> d.message <> "")
      in
      let number n = String.init 4 (fun i -> Char.chr ((n lsr (8 * i)) land 255)) in
      let frame = number 1 ^ number 1 ^ number (String.length changed) ^ changed in
      let out = Buffer.create 64 in
      let good = Batch.answer batches frame out in
      let bad = Batch.answer batches (String.sub frame 0 (any (String.length frame))) (Buffer.create 64) in
      told && Result.is_ok good && List.length (frames (Buffer.contents out) 0) = 2 && Result.is_error bad)

(* With an empty memory: the same answers, and numbers of labels that mean what they meant. *)
let renewed () =
  let f = Filter.make (question (load "enzymes.sc")) in
  let states = explore f in
  let label f i = Told.label (Filter.question f).loaded.model (Filter.label f i) in
  let labels f = List.init (Filter.labels f) (fun i -> Scc_exchange.Json.line (`Assoc (label f i))) in
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
        (Scc_exchange.Json.line (Told.answer f e))
        (Scc_exchange.Json.line (Told.answer other again))
  in
  List.iter one states;
  Alcotest.(check (list string)) "the same labels" before (labels other)

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
      ("questions", [ Alcotest.test_case "by name and number" `Quick properties ]);
    ]
