open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_graph_search

type fault = Transition.fault

type context = {
  local : Local.t;
  quotient : Quotient.within;
  walks : Walks.t option;  (** steps in which nothing is seen are one *)
  visible : (int -> bool) option;
  initial : State.t;
  encounters : Encounters.t;
  left : Section.memory;  (** of the first half of the slots of processes *)
  right : Section.memory;
  scene : Scene.t option;  (** where there are many *)
  draws : bool;  (** a draw is told by who waits for it, and marks nothing *)
  joined : bool;  (** draws and lots of one instant are one transition *)
  codec : Scc_codec.State_codec.t Lazy.t;
  mutable given_up : Transition.fault list;  (** at the states seen so far, each once *)
  seen : Entered.t;  (** the processes that states have which have been found *)
  mutable may_split : bool;  (** one of them may split at a split instant *)
}

let catalogue c = Local.catalogue c.local
let semantics c = Local.semantics c.local
let model c = Semantics.model (semantics c)
let start c = c.initial
let codec c = Lazy.force c.codec
let width c = Catalogue.width (catalogue c)
let representative c tuple =
  let tuple = match c.walks with Some walks -> Walks.standing walks tuple | None -> tuple in
  Quotient.representative c.quotient tuple
let initial c = representative c (Catalogue.encode (catalogue c) c.initial)
let names_differ c = Quotient.renames c.quotient

let same_but_for_places c (s : State.t) (t : State.t) =
  Quotient.same_but_for_places c.quotient (Catalogue.encode (catalogue c) s)
    (Catalogue.encode (catalogue c) t)

let keeps c tuple quantity = Quotient.keeps c.quotient tuple quantity
let longest c = Catalogue.greatest_bits (catalogue c)
let bits c tuple = (Length.longest (Catalogue.decode (catalogue c) tuple)).bits
let duration c label = Catalogue.duration (catalogue c) label
let transitions c label = Catalogue.transitions (catalogue c) label

let by_pairs (m : Model.t) =
  match (m.collisions, m.binding) with
  | (In_turn | Drawn), On_collision -> true
  | Together, _ | _, On_contact -> false

let make ?(events = []) ?(time_seen = Scc_property.Time_seen.Always) ?(quotient = Quotient.none) ?visible
    ?(joined = false) ?units ?(memory = 1 lsl 16) ?(few = 32) semantics initial =
  let m = Semantics.model semantics in
  let local = Local.create ~events ~time_seen ~memory semantics in
  let many = Model.part_count m > few in
  let scene = if Model.straight m && by_pairs m && many then Some (Scene.create local) else None in
  let encounters = Encounters.create ~memory:(4 * memory) local in
  let leaves = Array.length m.leaves in
  let left = Section.memory local ~first:0 ~beyond:(leaves / 2) in
  let right = Section.memory local ~first:(leaves / 2) ~beyond:leaves in
  let draws = Model.draws m && Option.is_none m.rigid && events = [] in
  let joined = joined && Model.leaves_to_chance m && Option.is_none m.rigid && events = [] in
  let walks = if joined then Option.bind units (fun units -> Walks.make ~units ~most:memory local) else None in
  let joins = match quotient.isometries with [] -> true | _ :: _ -> Joint_draws.joins semantics initial in
  let quotient = if joins then quotient else { quotient with isometries = [] } in
  let quotient = Quotient.within quotient (Local.catalogue local) in
  { local; quotient; walks; visible; initial; encounters; left; right; scene; draws; joined; given_up = [];
    codec = lazy (Scc_codec.State_codec.make m initial); seen = Entered.create (); may_split = false }

(* Processes that were only thought of, as targets of transitions that are not possible as yet, do not count. *)
let enter c number =
  if Entered.note c.seen number then begin
    let p = Catalogue.form (catalogue c) (Catalogue.body (catalogue c) number).form in
    if Option.is_some p.clock || Option.is_some (Lots.wait (model c) p) then c.may_split <- true
  end

let entered c changes =
  let leaves = Array.length (model c).leaves in
  for i = 0 to (Array.length changes / 2) - 1 do
    let number = changes.((2 * i) + 1) in
    if changes.(2 * i) < leaves && number <> Catalogue.nobody then enter c number
  done

let has_entered c changes =
  let leaves = Array.length (model c).leaves in
  let is_known slot number = slot >= leaves || number = Catalogue.nobody || Entered.mem c.seen number in
  let rec from i = i >= Array.length changes || (is_known changes.(i) changes.(i + 1) && from (i + 2)) in
  from 0

let share c table = Entered.share c.seen && Local.share c.local table (Texts.make c.codec)
let numbers_so_far c = Local.numbers_so_far c.local

let split_step c =
  match (model c).splits with
  | Every step when c.may_split -> Some step
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
  if Local.has_events c.local then tuple.(Catalogue.mark_slot (catalogue c)) <- mark

let events_of_mark c mark = Local.events_of c.local mark
let mark_of c events = Local.mark_of c.local events

let arrived c event =
  let slot = Catalogue.mark_slot (catalogue c) in
  match Local.place c.local event with
  | None -> fun _ -> false
  | Some place -> fun tuple -> List.exists (Int.equal place) (events_of_mark c tuple.(slot))

let events c = Local.events c.local

let happened c tuple =
  match events c with [] -> [] | _ :: _ -> events_of_mark c tuple.(Catalogue.mark_slot (catalogue c))

let set_happened c tuple places = set_mark c tuple (mark_of c places)

(** {2 Transitions of the whole} *)

let to_representative c tuple (s : Lts.step) =
  if Quotient.is_none c.quotient then s
  else
    let target = Quotient.representative c.quotient (Tuples.apply s.changes tuple) in
    { s with changes = Tuples.difference tuple target }

(* What can happen now but for the passing of time, all the last first; who is there, in the order of slots; and
   what tells the first time of contact, if nobody collides. *)
type now = {
  sections : unit -> Section.t * Section.t;
  can : Local.move Network.discrete;
  contact : limit:Rat.t option -> Rat.t option;
}

let present now =
  let one, other = now.sections () in
  Array.append (Section.present one) (Section.present other)

let joined a b =
  match (a, b) with
  | [||], c | c, [||] -> c
  | _ -> Array.append a b

(* Who is there, and where, changes only with time and by absorption: other transitions lead from representatives
   to representatives. *)
let pass c (tuple : int array) now d =
  let[@inline] change slot number rest = if tuple.(slot) = number then rest else slot :: number :: rest in
  let mark = if Local.has_events c.local then change (Catalogue.mark_slot (catalogue c)) 0 [] else [] in
  let mark_and_time =
    match Catalogue.time_after (catalogue c) tuple d with
    | None -> mark
    | Some number -> change (Catalogue.time_slot (catalogue c)) number mark
  in
  let one, other = now.sections () in
  let processes = joined (Section.after c.local d one) (Section.after c.local d other) in
  let changes = joined processes (Array.of_list mark_and_time) in
  let step = { Lts.label = Catalogue.time_label (catalogue c) d; changes } in
  let rest = Section.rest one && Section.rest other in
  if Array.length changes = 0 || Quotient.is_none c.quotient || rest then step
  else to_representative c tuple step

let step c tuple (m : Local.move) = if m.takes_out then to_representative c tuple m.step else m.step

(* [meet] tells what comes of collisions, the last first, and the first time of contact. *)
let by_sections c tuple meet =
  let left = Section.look c.left tuple and right = Section.look c.right tuple in
  let both left right = match left with [] -> right | _ :: _ -> right @ left in
  let urgent = both (Section.urgent left) (Section.urgent right) in
  let weak = both (Section.weak left) (Section.weak right) in
  let collisions, contact = meet c left right in
  { sections = (fun () -> (left, right)); can = { urgent; weak; collisions }; contact }

let never ~limit:_ = None

let by_pair c left right =
  if Section.in_relative_motion left right then begin
    let found = Encounters.among c.encounters (Array.append (Section.present left) (Section.present right)) in
    (Encounters.collisions found, fun ~limit:_ -> Encounters.first_contact c.encounters found)
  end
  else ([], never)

let processes present = Array.map (fun (a : Local.alone) -> a.body.process) present

(* Where two do not collide by themselves, but with all others that hang together with them (reading I-32), or meet
   at rest (reading I-33): all at once. *)
let at_once c left right =
  let processes = processes (Array.append (Section.present left) (Section.present right)) in
  let collisions = List.rev_map (Local.move c.local) (Network.together (Local.afresh c.local) processes) in
  (collisions, fun ~limit -> Collisions.first_time_of_contact (Local.afresh c.local) processes ~limit)

(* Where few move, who meets whom is told by pairs; else who is near whom in time is seen at once. *)
let few_movers = 16

let first_contact_of_many c scene present ~limit =
  if not (Scene.in_relative_motion scene) then None
  else
    let present = Later.force present in
    let movers = Array.fold_left (fun n (a : Local.alone) -> if a.rests then n else n + 1) 0 present in
    if movers <= few_movers then Encounters.first_contact c.encounters (Encounters.among c.encounters present)
    else Collisions.first_time_of_contact (Local.afresh c.local) (processes present) ~limit

let of_many c scene tuple =
  Scene.look scene tuple;
  let present = Later.make (fun () -> Scene.present scene) in
  let sections = Later.make (fun () -> (Section.of_present (Later.force present), Section.nobody)) in
  {
    sections = (fun () -> Later.force sections);
    can = { urgent = Scene.urgent scene; weak = Scene.weak scene; collisions = Scene.collisions scene };
    contact = (fun ~limit -> first_contact_of_many c scene present ~limit);
  }

let now c tuple =
  match c.scene with
  | Some scene -> of_many c scene tuple
  | None -> by_sections c tuple (if by_pairs (model c) then by_pair else at_once)

let choices c source =
  let encoded (t : Transition.t) =
    let target = Catalogue.encode (catalogue c) t.target in
    set_mark c target (Local.mark c.local ~source t.label);
    representative c target
  in
  let with_target t = (t, lazy (encoded t)) in
  Result.map (List.map with_target) (Network.successors (semantics c) source)

let whole c tuple =
  let step (t, there) : Lts.step =
    { label = Catalogue.label_of_transition (catalogue c) t; changes = Tuples.difference tuple (Lazy.force there) }
  in
  match choices c (Catalogue.decode (catalogue c) tuple) with
  | Ok transitions -> Ok (List.map step transitions)
  | Error fault when is_given_up fault ->
    if not (List.mem fault c.given_up) then c.given_up <- fault :: c.given_up;
    Ok []
  | Error _ as fault -> fault

let by_parts c tuple =
  let now = now c tuple in
  let time () =
    let one, other = now.sections () in
    let wait = Option.merge Rat.min (Section.wait one) (Section.wait other) in
    match Option.merge Rat.min wait (now.contact ~limit:wait) with
    | None -> []
    | Some d -> [ pass c tuple now d ]
  in
  Network.in_order (step c tuple) (Local.tied c.local now.can) ~time

(** {2 Draws} *)

let drawn c tuple p outcome =
  let catalogue = catalogue c in
  let label = Catalogue.label catalogue (Steer.draw_label p outcome) in
  let slot = Catalogue.first_leaf p in
  let number = Catalogue.process catalogue (State.with_draw (Some (Drawn (fst outcome))) p) in
  let target = Array.copy tuple in
  target.(slot) <- number;
  let target' = Quotient.representative c.quotient target in
  { Lts.label; changes = (if target' == target then [| slot; number |] else Tuples.difference tuple target') }

(* Those that wait to draw; [None] where lots are pending. *)
let waiters c tuple =
  let rec from i found =
    if i < 0 then Some found
    else if tuple.(i) = Catalogue.nobody then from (i - 1) found
    else
      let p = (Catalogue.body (catalogue c) tuple.(i)).process in
      if Lots.is_pending p then None
      else from (i - 1) (match p.draw with Some Waits -> p :: found | Some (Drawn _) | None -> found)
  in
  from (Array.length (model c).leaves - 1) []

(* While two or more wait to draw (rule Draw), a draw changes one process alone: what all have drawn takes effect
   when the last one has, and who is first is told by those who wait. Of bodies that turn nothing is said here, as
   turns may end before each draw. *)
let draws c tuple =
  if not c.draws then None
  else
    match waiters c tuple with
    | Some (_ :: _ :: _ as processes) ->
      let first = Option.get (Process.first_by_place (model c) processes) in
      let step = Catalogue.step (catalogue c) tuple and time = Catalogue.time (catalogue c) tuple in
      Steer.chances (semantics c) (State.make ~processes:[ first ] ~step ~time) first
      |> Result.map (List.map (drawn c tuple first))
      |> Option.some
    | Some ([] | [ _ ]) | None -> None

(* {2 Joined draws} *)

(* How many joint outcomes the draws and lots that are pending have before any are merged, or more than are joined.
   A lot counts as two. *)
let pending_outcomes c tuple =
  let step = Catalogue.step (catalogue c) tuple and time = Catalogue.time (catalogue c) tuple in
  let of_process (p : State.process) =
    if Lots.is_pending p then 2
    else
      match p.draw with
      | None | Some (Drawn _) -> 1
      | Some Waits -> (
          match Steer.chances (semantics c) (State.make ~processes:[ p ] ~step ~time) p with
          | Ok chances -> List.length chances
          | Error _ -> 1)
  in
  let more n number =
    if n > Joint_draws.most || number = Catalogue.nobody then n
    else n * of_process (Catalogue.body (catalogue c) number).process
  in
  Array.fold_left more 1 (Array.sub tuple 0 (Array.length (model c).leaves))

let waiting c tuple = Option.map List.length (waiters c tuple)
let one_by_one c tuple = match draws c tuple with Some steps -> steps | None -> whole c tuple

let outcome c tuple (s : Lts.step) =
  let chance = Option.get (Catalogue.chance (catalogue c) s.label) in
  { Joint_draws.tuple = Tuples.apply s.changes tuple; chance; transitions = 1 }

(* Several velocities are drawn, each of which takes effect whatever the others are. Walkers that wait may
   block each other (rule Blocked). *)
let several_velocities c tuple =
  c.draws
  && (not (Model.stops_walkers (model c)))
  && match waiting c tuple with Some n -> n > 1 | None -> false

(* The outcomes of all draws of velocities; [None] where others are due, or there are too many. *)
let by_velocities c tuple =
  let representative (o : Joint_draws.outcome) = { o with tuple = Quotient.representative c.quotient o.tuple } in
  if several_velocities c tuple then
    Result.map (Option.map (List.map representative)) (Joint_draws.velocities (semantics c) (catalogue c) tuple)
  else Ok None

let is_drawn c (s : Lts.step) = Option.is_some (Catalogue.chance (catalogue c) s.label)

(* What a state that draws is left by; [None] for all others. *)
let leave c tuple =
  if waiting c tuple = Some 0 then Ok None
  else
    let* outcomes = by_velocities c tuple in
    match outcomes with
    | Some _ -> Ok outcomes
    | None ->
      let* steps = one_by_one c tuple in
      Ok (if List.exists (is_drawn c) steps then Some (List.map (outcome c tuple) steps) else None)

let by_walks c tuple =
  Option.bind c.walks (fun walks -> Walk_draws.outcomes walks tuple ~representative:(representative c))

let joined c tuple =
  let step (o : Joint_draws.outcome) =
    let label = Catalogue.joint (catalogue c) { chance = o.chance; transitions = o.transitions } in
    { Lts.label; changes = Tuples.difference tuple o.tuple }
  in
  let through outcomes ~otherwise =
    let* all = Joint_draws.through (leave c) outcomes in
    match all with Some all -> Ok (List.map step all) | None -> otherwise ()
  in
  let* outcomes = by_velocities c tuple in
  match (by_walks c tuple, outcomes) with
  | Some outcomes, _ -> Ok (List.map step outcomes)
  | None, Some outcomes -> through outcomes ~otherwise:(fun () -> one_by_one c tuple)
  | None, None when several_velocities c tuple -> one_by_one c tuple
  | None, None ->
    let* steps = one_by_one c tuple in
    let goes_on s = is_drawn c s && waiting c (Tuples.apply s.Lts.changes tuple) <> Some 0 in
    if List.exists goes_on steps && pending_outcomes c tuple <= Joint_draws.most then
      through (List.map (outcome c tuple) steps) ~otherwise:(fun () -> Ok steps)
    else Ok steps

let passes c tuple =
  let step (label, target) = { Lts.label; changes = Tuples.difference tuple (representative c target) } in
  Option.map step (Option.bind c.walks (fun walks -> Walks.pass walks tuple))

let successors c tuple =
  if Model.straight (model c) then Ok (by_parts c tuple)
  else if c.joined && waiting c tuple <> Some 0 then joined c tuple
  else match passes c tuple with Some step -> Ok [ step ] | None -> one_by_one c tuple

let draws_towards c state target =
  let test tuple = representative c tuple = target in
  Option.bind c.walks (fun walks -> Walk_draws.towards walks (Catalogue.encode (catalogue c) state) test)

let reduced c tuple =
  match c.visible with
  | None -> None
  | Some _ when not (Model.straight (model c)) -> None
  | Some visible -> (
      let now = now c tuple in
      if not (Network.is_urgent now.can) then None
      else
        Group_moves.first_hidden (semantics c) visible (processes (present now)) now.can
        |> Option.map (Network.in_order (step c tuple) ~time:(fun () -> [])))
