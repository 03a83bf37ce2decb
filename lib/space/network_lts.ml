open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_explore
open Scc_evaluate

type fault = Transition.fault

(* What a transition of some processes changes of the whole. *)
type move = {
  step : Lts.step;
  leaf : int;  (** of one of them *)
  takes_out : bool;  (** one of them is in the network no more (rule Absorb) *)
}

(* What a form decides, wherever the process is. *)
type nature = { splits : bool; wait : Rat.t option  (** until an eps expires or the next split instant *) }

(* What a process does by itself. *)
type alone = {
  body : Catalogue.body;
  nature : nature;
  urgent : move list;
  weak : move list;
  rests : bool;
  mutable passed : Rat.t;  (** the last time that passed for it, and what became of it *)
  mutable after : int;
}

(* What two processes that move relative to each other do. *)
type together = { pair : int; collisions : move list; contact : Rat.t option }

(* Which events, by their places in the list, have just happened. *)
module Marks = Catalogue.Interned (struct
    type t = int list

    let equal = List.equal Int.equal
    let hash = List.fold_left (fun h i -> (31 * h) + i + 1) 0
  end)

(* What numbers stand for, and the events to look for. *)
type book = {
  semantics : Semantics.t;
  catalogue : Catalogue.t;
  events : Property.event list;
  marks : Marks.t;
  natures : nature Growable.t;  (** of the first forms *)
}

type context = {
  book : book;
  quotient : Quotient.t;
  visible : (int -> bool) option;
  initial : State.t;
  singles : alone array;  (** the last that were asked for, at their numbers modulo the size *)
  pairs : together array;  (** likewise *)
  mutable given_up : Transition.fault list;  (** at the states seen so far, each once *)
}

let no_pair = { pair = -1; collisions = []; contact = None }

let catalogue c = c.book.catalogue
let semantics c = c.book.semantics
let model c = Semantics.model (semantics c)
let start c = c.initial
let width c = Catalogue.width (catalogue c)
let initial c = Quotient.representative c.quotient (catalogue c) (Catalogue.encode (catalogue c) c.initial)
let representative c tuple = Quotient.representative c.quotient (catalogue c) tuple

let same_but_for_places c (s : State.t) (t : State.t) =
  Quotient.same_but_for_places c.quotient (catalogue c) (Catalogue.encode (catalogue c) s)
    (Catalogue.encode (catalogue c) t)

let keeps c tuple quantity = Quotient.keeps c.quotient (catalogue c) tuple quantity
let longest c = Catalogue.greatest_bits (catalogue c)
let bits c tuple = (Length.longest (Catalogue.decode (catalogue c) tuple)).bits
let duration c label = Catalogue.duration (catalogue c) label
let network processes = State.make ~processes ~step:None ~time:None

let mark b ~source label =
  match b.events with
  | [] -> 0
  | _ :: _ ->
    let happened = List.mapi (fun i e -> if Event.matches ~source label e then Some i else None) b.events in
    Marks.intern b.marks (List.filter_map Fun.id happened)

(* What happens to some processes: they leave their slots, and others enter theirs. *)
let move b (o : Transition.outcome) =
  let slots = Hashtbl.create 8 in
  let leave p = Hashtbl.replace slots (Catalogue.first_leaf p) Catalogue.nobody in
  let enter p = Hashtbl.replace slots (Catalogue.first_leaf p) (Catalogue.process b.catalogue p) in
  List.iter leave o.gone;
  List.iter enter o.come;
  (match b.events with
   | [] -> ()
   | _ :: _ ->
     Hashtbl.replace slots (Catalogue.mark_slot b.catalogue) (mark b ~source:(network o.gone) o.label));
  let changes = Hashtbl.fold (fun slot v acc -> (slot, v) :: acc) slots [] in
  let in_order = List.sort (fun (i, _) (j, _) -> Int.compare i j) changes in
  {
    step =
      {
        label = Catalogue.label b.catalogue o.label;
        changes = Array.of_list (List.concat_map (fun (slot, v) -> [ slot; v ]) in_order);
      };
    leaf = Catalogue.first_leaf (List.hd o.gone);
    takes_out = o.come = [];
  }

let least a b =
  match (a, b) with
  | None, x | x, None -> x
  | Some s, Some t -> Some (Rat.min s t)

let look_at_form b p =
  let splits = Network.urgent b.semantics p <> [] || Splits.weak b.semantics p <> [] in
  { splits; wait = Time.wait (Semantics.model b.semantics) p }

let nature b form =
  for i = Growable.length b.natures to form do
    Growable.push b.natures (look_at_form b (Catalogue.form b.catalogue i))
  done;
  Growable.get b.natures form

let look b number =
  let body = Catalogue.body b.catalogue number in
  let nature = nature b body.form in
  let moves splits = List.map (move b) (splits b.semantics body.process) in
  {
    body; nature;
    urgent = (if nature.splits then moves Network.urgent else []);
    weak = (if nature.splits then moves Network.weak else []);
    rests = Catalogue.resting b.catalogue body.velocity;
    passed = Rat.zero;
    after = number;
  }

let alone c number =
  let k = number land (Array.length c.singles - 1) in
  let a = Array.unsafe_get c.singles k in
  if a.body.number = number then a
  else begin
    let a = look c.book number in
    c.singles.(k) <- a;
    a
  end

let look_at_pair book pair a b =
  let p = a.body.process and q = b.body.process in
  let collisions = List.map (move book) (Network.together book.semantics [| p; q |]) in
  let contact =
    match collisions with
    | [] -> Collisions.first_time_of_contact book.semantics [| p; q |] ~limit:None
    | _ :: _ -> None
  in
  { pair; collisions; contact }

let together c a b =
  let pair = (a.body.number lsl 31) lor b.body.number in
  let k = (((pair lxor (pair lsr 29)) * 0x1E3779B97F4A7C15) lsr 40) land (Array.length c.pairs - 1) in
  let t = Array.unsafe_get c.pairs k in
  if t.pair = pair then t
  else begin
    let t = look_at_pair c.book pair a b in
    c.pairs.(k) <- t;
    t
  end

let make ?(events = []) ?(time_seen = Time_seen.Always) ?(quotient = Quotient.none) ?visible
    ?(memory = 1 lsl 14) semantics initial =
  let model = Semantics.model semantics in
  let marked = match events with [] -> false | _ :: _ -> true in
  let catalogue = Catalogue.create ~marked ~time_seen ~memory model in
  let book = { semantics; catalogue; events; marks = Marks.create (); natures = Growable.create () } in
  ignore (Marks.intern book.marks []);
  (* Any process will do to fill the memory: it is looked at like the others. *)
  let filler =
    match Array.to_list initial.State.processes with
    | [] -> [||]
    | p :: _ when Model.straight model -> Array.make memory (look book (Catalogue.process catalogue p))
    | _ :: _ -> [||]
  in
  { book; quotient; visible; initial; singles = filler; pairs = Array.make memory no_pair; given_up = [] }

let split_step c =
  let may_split (p : State.process) = Option.is_some p.clock || Option.is_some (Lots.wait (model c) p) in
  match (model c).splits with
  | Every step when Catalogue.exists_form (catalogue c) may_split -> Some step
  | Every _ | Any_time -> None

let given_up c = List.rev c.given_up

let is_given_up : Transition.fault -> bool = function
  | Persistent_contact _ -> true
  | Bad_law _ | Bad_chance _ -> false

let is_dead_end semantics state =
  match Network.successors semantics state with
  | Ok _ -> false
  | Error fault -> is_given_up fault

let set_mark c tuple mark =
  match c.book.events with [] -> () | _ :: _ -> tuple.(Catalogue.mark_slot (catalogue c)) <- mark

let unmarked c tuple =
  let copy = Array.copy tuple in
  set_mark c copy 0;
  copy

let arrived c tuple event =
  let happened = Marks.get c.book.marks tuple.(Catalogue.mark_slot (catalogue c)) in
  List.exists (fun i -> Formula.equal_event (List.nth c.book.events i) event) happened

(** {2 Transitions of the whole} *)

(* Nothing of it changes with time but its place. *)
let ageless a = Option.is_none a.nature.wait

let after c d a =
  if ageless a && a.rests then a.body.number
  else begin
    if not (Rat.equal d a.passed) then begin
      a.after <-
        (if ageless a then Catalogue.displaced (catalogue c) d a.body
         else
           Time.pass_process (model c) d a.body.process |> Catalogue.process (catalogue c));
      a.passed <- d
    end;
    a.after
  end

(* Who is there, and where, changes only with time and by absorption: other transitions lead from representatives
   to representatives. *)
let pass c tuple present d : Lts.step =
  let label = Catalogue.label (catalogue c) (Transition.Time d) in
  let target = Array.copy tuple in
  Array.iter (fun a -> target.(Catalogue.first_leaf a.body.process) <- after c d a) present;
  Catalogue.pass_time (catalogue c) target d;
  set_mark c target 0;
  let moves = Array.exists (fun a -> not a.rests) present in
  let target = if moves then Quotient.representative c.quotient (catalogue c) target else target in
  { label; changes = Tuples.difference tuple target }

let step c tuple m : Lts.step =
  if not m.takes_out then m.step
  else
    let target = Quotient.representative c.quotient (catalogue c) (Tuples.apply m.step.changes tuple) in
    { m.step with changes = Tuples.difference tuple target }

let present c tuple =
  let n = Array.length (model c).leaves in
  let rec from i acc =
    if i < 0 then Array.of_list acc
    else
      let p = Array.unsafe_get tuple i in
      from (i - 1) (if p = Catalogue.nobody then acc else alone c p :: acc)
  in
  from (n - 1) []

let in_relative_motion present =
  let rec from i =
    i < Array.length present
    && (present.(i).body.velocity <> present.(0).body.velocity || from (i + 1))
  in
  from 1

(* Collisions, the last first, and what tells the first time of contact, of pairs one by one. Who asks for
   collisions alone need not wait for the rest. *)
let meetings_of_few c present =
  let collisions = ref [] and contact = ref None in
  let k = Array.length present in
  for i = 0 to k - 2 do
    for j = i + 1 to k - 1 do
      let a = present.(i) and b = present.(j) in
      if a.body.velocity <> b.body.velocity then begin
        let t = together c a b in
        collisions := List.rev_append t.collisions !collisions;
        contact := least !contact t.contact
      end
    done
  done;
  (!collisions, fun ~limit:_ -> !contact)

(* The same of many: who is near whom is seen at once. *)
let meetings_of_many c present =
  let processes = Array.map (fun a -> a.body.process) present in
  let resolved acc (m : Kinematics.meeting) =
    List.rev_append (together c present.(m.first) present.(m.second)).collisions acc
  in
  let collisions = List.fold_left resolved [] (Collisions.meetings (semantics c) processes) in
  (collisions, fun ~limit -> Collisions.first_time_of_contact (semantics c) processes ~limit)

(* Where two do not collide by themselves, but with all others that hang together with them (reading I-32), or meet
   at rest (reading I-33): all at once. *)
let meetings_at_once c present =
  let processes = Array.map (fun a -> a.body.process) present in
  let collisions = List.rev_map (move c.book) (Network.together (semantics c) processes) in
  (collisions, fun ~limit -> Collisions.first_time_of_contact (semantics c) processes ~limit)

let by_pairs (m : Model.t) =
  match (m.collisions, m.binding) with
  | In_turn, On_collision -> true
  | Together, _ | _, On_contact -> false

(* Whether there are so few basic shapes that it pays to remember what every two processes do. *)
let few_shapes = 32

let are_few present =
  let shapes n a = n + Array.length a.body.process.State.leaves in
  Array.length present <= few_shapes && Array.fold_left shapes 0 present <= few_shapes

let meetings c present =
  if not (by_pairs (model c)) then meetings_at_once c present
  else if not (in_relative_motion present) then ([], fun ~limit:_ -> None)
  else if are_few present then meetings_of_few c present
  else meetings_of_many c present

let choices c source =
  let encoded (t : Transition.t) =
    let target = Catalogue.encode (catalogue c) t.target in
    set_mark c target (mark c.book ~source t.label);
    (t, Quotient.representative c.quotient (catalogue c) target)
  in
  Result.map (List.map encoded) (Network.successors (semantics c) source)

let whole c tuple =
  let step ((t : Transition.t), target) : Lts.step =
    { label = Catalogue.label (catalogue c) t.label; changes = Tuples.difference tuple target }
  in
  match choices c (Catalogue.decode (catalogue c) tuple) with
  | Ok transitions -> Ok (List.map step transitions)
  | Error fault when is_given_up fault ->
    if not (List.mem fault c.given_up) then c.given_up <- fault :: c.given_up;
    Ok []
  | Error _ as fault -> fault

let discrete c present =
  let urgent = Array.fold_left (fun acc (a : alone) -> List.rev_append a.urgent acc) [] present in
  let weak = Array.fold_left (fun acc (a : alone) -> List.rev_append a.weak acc) [] present in
  let collisions, contact = meetings c present in
  ({ Network.urgent; weak; collisions }, contact)

let wait present = Array.fold_left (fun d a -> least d a.nature.wait) None present

let by_parts c tuple present =
  let d, contact = discrete c present in
  let time () =
    let wait = wait present in
    let delay = least wait (contact ~limit:wait) in
    Option.to_list (Option.map (pass c tuple present) delay)
  in
  Network.in_order (step c tuple) d ~time

let successors c tuple =
  if Model.straight (model c) then Ok (by_parts c tuple (present c tuple)) else whole c tuple

(** {2 One group of many} *)

(* Of the groups with something urgent to do, the first in which nobody can be seen, if others could act as
   well. *)
let group_moves semantics visible present (d : move Network.discrete) =
  let groups = Groups.of_processes semantics (Array.map (fun a -> a.body.process) present) in
  let group m = Groups.of_leaf groups m.leaf in
  let hidden g = not (List.exists visible (Groups.leaves groups g)) in
  let urgent = List.rev_append d.urgent d.collisions in
  let candidates = List.sort_uniq Int.compare (List.map group urgent) in
  match List.find_opt hidden candidates with
  | None -> None
  | Some g ->
    let inside = List.filter (fun m -> group m = g) in
    let mine = { Network.urgent = inside d.urgent; weak = inside d.weak; collisions = inside d.collisions } in
    let count (d : move Network.discrete) = List.length d.urgent + List.length d.weak + List.length d.collisions in
    if count mine < count d then Some mine else None

let reduced c tuple =
  match c.visible with
  | None -> None
  | Some _ when not (Model.straight (model c)) -> None
  | Some visible -> (
      let present = present c tuple in
      let d, _ = discrete c present in
      if not (Network.is_urgent d) then None
      else
        group_moves (semantics c) visible present d
        |> Option.map (Network.in_order (step c tuple) ~time:(fun () -> [])))
