open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_engine

type t = {
  semantics : Semantics.t;
  run : Run.t;
  kept : bool array;  (** the leaves of the slice *)
  mutable steps : Witness.step list;  (** the last first *)
  mutable within_instant : int;  (** transitions since time has passed *)
}

let fail () = Scc_base.Bug.fail __POS__ "a run of a slice is no run of the whole network"

(* Groups that are left out make so many at most, each of them. *)
let patience t = 10_000 * Array.length (Semantics.model t.semantics).leaves

let labels t = match Run.labels t.run with Ok found -> Run.list found | Error _ -> fail ()

(* The probability of a transition to be taken, where chance decides between urgent ones (rule Ties). *)
let tie_chance t choice =
  if not (Model.draws_ties (Semantics.model t.semantics)) then None
  else
    match Network.successors t.semantics (Run.state t.run) with
    | Ok transitions -> Option.bind (List.nth_opt transitions choice) (fun (x : Transition.t) -> x.chance)
    | Error _ -> fail ()

let take t choice =
  let chance = tie_chance t choice in
  let a = Run.take t.run choice in
  let target = Run.state t.run in
  let chance = if Transition.is_drawn a.label then Some (Transition.chance a.label) else chance in
  let transition = { Transition.label = a.label; rules = a.rules; fired = []; target; chance; rounded = None } in
  t.within_instant <- (match a.label with Time _ -> 0 | _ -> t.within_instant + 1);
  if t.within_instant > patience t then fail ();
  t.steps <- { choice; transition; time = Run.elapsed t.run } :: t.steps

(* The labels that satisfy a condition, with their choices. *)
let those labels condition =
  List.filter (fun (_, label) -> condition label) (List.mapi (fun k label -> (k, label)) labels)

let some_leaf (label : Transition.label) =
  match (label, Transition.bonds label) with
  | _, b :: _ -> Some b.one.at
  | Bounce { firsts = i :: _; _ }, [] -> Some i
  | (Absorb { first; _ } | Draw { first; _ }), [] -> Some first
  | Lot { bond; _ }, [] -> Some bond.one.at
  | (Time _ | Bounce _ | Bind _ | Close _ | Weak_split _ | Strong_split _), [] -> None

let is_of_slice t label = match some_leaf label with Some i -> t.kept.(i) | None -> false

(* Those that are left out draw when it is their turn: any velocity will do. *)
let rec let_others_draw t =
  match labels t with
  | (Draw _ as label) :: _ when not (is_of_slice t label) ->
    take t 0;
    let_others_draw t
  | _ -> ()

(** Where a run is that was to go on to an instant. *)
type place =
  | There
  | Before of int option  (** in a state before it, and time passes beyond it by this choice, or for ever *)

let rec advance t ~until =
  if Algebraic.compare_rat until (Run.elapsed t.run) = 0 then There
  else
    let labels = labels t in
    match (those labels Transition.is_time, those labels Transition.is_urgent) with
    | (k, time) :: _, _ ->
      let next = Rat.add (Run.elapsed t.run) (Transition.duration_of time) in
      if Algebraic.compare_rat until next < 0 then Before (Some k)
      else begin
        take t k;
        advance t ~until
      end
    | [], (k, label) :: _ ->
      if is_of_slice t label then fail ();
      take t k;
      advance t ~until
    | [], [] -> if labels = [] then Before None else fail ()

let arrive t time =
  if Algebraic.compare_rat (Algebraic.of_rat time) (Run.elapsed t.run) < 0 then fail ();
  match advance t ~until:(Algebraic.of_rat time) with There -> () | Before _ -> fail ()

(* The processes of the slice in a state of the whole. *)
let same_in_slice t (slice : State.t) (whole : State.t) =
  let of_slice (p : State.process) = t.kept.(p.leaves.(0).leaf) in
  let processes = Array.of_list (List.filter of_slice (Array.to_list whole.processes)) in
  Array.length processes = Array.length slice.processes
  && Array.for_all2 State.equal_process processes slice.processes

(* Transitions with the same label may lead to different behaviours. *)
let choose t (step : Witness.step) =
  let label = step.transition.label and target = step.transition.target in
  match those (labels t) (Transition.equal_label label) with
  | [] -> fail ()
  | [ found ] -> found
  | several -> (
      match Network.successors t.semantics (Run.state t.run) with
      | Error _ -> fail ()
      | Ok transitions ->
        let leads (k, _) = same_in_slice t target (List.nth transitions k).target in
        (match List.find_opt leads several with Some found -> found | None -> fail ()))

let repeat t (step : Witness.step) =
  match step.transition.label with
  | Time _ -> ()
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ ->
    arrive t step.time;
    let_others_draw t;
    let k, label = choose t step in
    take t k;
    (* What is drawn takes effect when all have drawn. *)
    (match label with Draw _ -> let_others_draw t | _ -> ());
    if not (same_in_slice t step.transition.target (Run.state t.run)) then fail ()

let since t instant = Algebraic.add_rat (Rat.neg (Run.elapsed t.run)) instant

let finish t (w : Witness.t) : Witness.finish =
  match w.finish with
  | At_state ->
    arrive t (Witness.time w);
    At_state
  | During { from; open_piece; _ } -> (
      let instant = Witness.instant w in
      match advance t ~until:instant with
      | There -> At_state
      | Before choice ->
        let offset = since t instant in
        let from = since t (Algebraic.add_rat (Witness.time w) from) in
        if open_piece && Algebraic.compare_rat from Rat.zero >= 0 then
          During { choice; offset; open_piece; from }
        else During { choice; offset; open_piece = false; from = offset })
  | Rests _ | Stops | Repeats _ | Passes _ | Goes_on _ -> Scc_base.Bug.fail __POS__ "not the witness of a search"

let timed semantics ~initial (w : Witness.t) =
  let kept = Array.make (Array.length (Semantics.model semantics).leaves) false in
  Array.iter
    (fun (p : State.process) -> Array.iter (fun (l : State.leaf) -> kept.(l.leaf) <- true) p.leaves)
    w.initial.processes;
  let t = { semantics; run = Run.resume semantics initial; kept; steps = []; within_instant = 0 } in
  List.iter (repeat t) w.steps;
  let finish = finish t w in
  { w with initial; steps = List.rev t.steps; last = Run.state t.run; finish }
