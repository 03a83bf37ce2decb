open Scc_graph_search

(* What is told to one home. *)
type home = {
  targets : Columns.targets;
  sources : Buffer.t;
  choices : Buffer.t;
  prints : Buffer.t;
  mutable count : int;
}

type t = {
  known : Prints.t;
  mutable mark : int;  (** what is remembered from this number on may be forgotten *)
  states : Columns.states;
  print : Keys.fingerprint;  (** to work with *)
  mutable homes : home array;
}

let make () =
  { known = Prints.create (); mark = 0; states = Columns.states (); print = Keys.no_fingerprint (); homes = [||] }

let home () =
  let b () = Buffer.create 4096 in
  { targets = Columns.targets (); sources = b (); choices = b (); prints = b (); count = 0 }

let clear h =
  Columns.clear_targets h.targets;
  List.iter Buffer.clear [ h.sources; h.choices; h.prints ];
  h.count <- 0

(* {1 States} *)

let tell t filter index choice target =
  let h = t.homes.(t.print.(0) mod Array.length t.homes) in
  Columns.put_target filter h.targets h.count target t.print;
  Frame.put_number h.sources index;
  Frame.put_number h.choices choice;
  Keys.put_fingerprint h.prints t.print;
  h.count <- h.count + 1

(* The target is the source, changed for a moment. *)
let step t filter index source before target choice (s : Lts.step) =
  let changes = s.changes in
  for i = 0 to (Array.length changes / 2) - 1 do
    target.(changes.(2 * i)) <- changes.((2 * i) + 1)
  done;
  Keys.move (Filter.keys filter) ~into:t.print before source changes target;
  let known = Prints.size t.known in
  if Prints.intern t.known t.print = known then tell t filter index choice target;
  for i = 0 to (Array.length changes / 2) - 1 do
    let slot = changes.(2 * i) in
    target.(slot) <- source.(slot)
  done

let steps t filter index source steps =
  let before = Keys.fingerprint (Filter.keys filter) source and target = Array.copy source in
  let rec each choice = function
    | [] -> ()
    | s :: rest ->
      step t filter index source before target choice s;
      each (choice + 1) rest
  in
  each 0 steps

let put_home out h =
  let text = Told.of_targets (List.rev h.targets.doubts) in
  let c = h.targets in
  Frame.put out
    [ h.count; Buffer.length c.bytes; String.length text ]
    [ h.prints; h.sources; h.choices; c.lengths; c.flags; c.goals; c.bytes ]
    text

let most_homes = 1 lsl 16

let expand t filter frame out =
  let numbers = Frame.numbers frame in
  let count = if numbers = [||] then 0 else numbers.(0) in
  if count < 1 || count > most_homes then Frame.lost "%d homes are none, or too many" count;
  if Array.length t.homes <> count then t.homes <- Array.init count (fun _ -> home ());
  Array.iter clear t.homes;
  Columns.clear t.states;
  let lengths = Array.sub numbers 1 (Array.length numbers - 1) in
  Columns.read filter t.states frame ~from:(Frame.bytes_from numbers) lengths (steps t filter);
  let text = Told.of_moves (Filter.question filter).loaded.model [] (List.rev t.states.notes) in
  Frame.put out
    [ Array.length lengths; count; String.length text ]
    [ t.states.counts; t.states.follows; t.states.ahead ]
    text;
  Array.iter (put_home out) t.homes

(* {1 Fingerprints} *)

let print_size = 4 * Keys.words

let meet t frame out =
  let from = Frame.bytes_from (Frame.numbers frame) in
  let size = String.length frame - from in
  if from > 8 || size mod print_size <> 0 then Frame.lost "these are no fingerprints of %d bytes" print_size;
  let answers = Buffer.create (size / 4) in
  for i = 0 to (size / print_size) - 1 do
    for k = 0 to Keys.words - 1 do
      t.print.(k) <- Frame.number frame (from + (print_size * i) + (4 * k))
    done;
    let number = Prints.intern t.known t.print in
    Frame.put_number answers (Int.max 0 (number + 1 - t.mark))
  done;
  Frame.put out [ size / print_size ] [ answers ] ""

let keep t frame out =
  (match Frame.numbers frame with
   | [| 0 |] -> ()
   | [| 1 |] -> Prints.cut t.known t.mark
   | [| 2 |] -> Prints.cut t.known 0
   | _ -> Frame.lost "it says neither what to keep nor what to forget");
  if String.length frame > 12 then Frame.lost "there is more than it says";
  t.mark <- Prints.size t.known;
  Frame.put out [ t.mark ] [] ""
