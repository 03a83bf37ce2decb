open Scc_base
open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_evaluate
open Scc_state_sets
open Scc_symbolic
open Scc_explain

let initial semantics declared =
  match Network.initial semantics declared with
  | Ok state -> state
  | Error _ -> Bug.fail __POS__ "a law of motion in a model with ranges"

let named (m : Model.t) values =
  List.mapi (fun i v -> (m.ranges.(i).Ranges.name, v)) (Array.to_list values)

let numbered list = List.mapi (fun i x -> (i, x)) list

(* A label that tells processes by some of their leaves, by the first ones of a state. *)
let told_in state (label : Transition.label) : Transition.label =
  let first leaf =
    match State.home state leaf with Some p -> p.leaves.(0).leaf | None -> leaf
  in
  match label with
  | Bounce b -> Bounce { b with firsts = List.sort Int.compare (List.map first b.firsts) }
  | Absorb a -> Absorb { a with first = first a.first }
  | Draw d -> Draw { d with first = first d.first }
  | Time _ | Bind _ | Close _ | Weak_split _ | Strong_split _ | Lot _ -> label

(* The transitions that a step may be, each with its number among the successors. *)
let candidates c state (step : Concrete.step) =
  let successors = match Network.successors c state with Ok list -> numbered list | Error _ -> [] in
  let labelled is = List.filter (fun (_, (t : Transition.t)) -> is t.label) successors in
  let time = function Transition.Time _ -> true | _ -> false in
  match step with
  | Happens label -> labelled (Transition.equal_label (told_in state label))
  | Passes d -> labelled (function Time t -> Rat.equal t d | _ -> false)
  | Passes_some d -> (
      let choice = match labelled time with (i, _) :: _ -> i | [] -> List.length successors in
      match Network.wait c state d with
      | Ok (Some t) -> [ (choice, t) ]
      | Ok None | Error _ -> [])

(* Two summands may do something of one label, with different outcomes: the first way to go on is taken that leads
   where it should. *)
let follow c ~reached start (steps : Concrete.step list) =
  (* The ways that are still to be tried, that which goes on first. *)
  let rec try_ = function
    | [] -> None
    | (state, _, [], taken) :: others ->
      let taken = List.rev taken in
      if reached state taken then Some (state, taken) else try_ others
    | (state, time, step :: rest, taken) :: others ->
      let way (choice, (t : Transition.t)) =
        let time = Rat.add time (Transition.duration t) in
        (t.target, time, rest, { Witness.choice; transition = t; time } :: taken)
      in
      try_ (List.map way (candidates c state step) @ others)
  in
  try_ [ (start, Rat.zero, steps, []) ]

(* {1 Runs of a slice}

   As {!Scc_explain.Lift}, where time may stop anywhere: what is left out does what it must, the first of it, when
   time could not pass otherwise. *)

(* The transitions of a run that take no time, with the instants of them, and when it ends. *)
let instants (run : Concrete.t) =
  let add (time, found) (step : Concrete.step) =
    match step with
    | Happens label -> (time, (time, label) :: found)
    | Passes d | Passes_some d -> (Rat.add time d, found)
  in
  let time, found = List.fold_left add (Rat.zero, []) run.steps in
  (List.rev found, Rat.add time run.offset)

(* With how much time passes after the last step, until the run ends. *)
let interleave c ~reached start happens ~until =
  let rec try_ = function
    | [] -> None
    | (state, time, happens, taken) :: others -> (
        let next = match happens with (t, _) :: _ -> t | [] -> until in
        let wait = Rat.sub next time in
        let ends () =
          if reached state taken wait then Some (state, List.rev taken, wait) else try_ others
        in
        let go rest ways =
          let way (choice, (t : Transition.t)) =
            let time = Rat.add time (Transition.duration t) in
            (t.target, time, rest, { Witness.choice; transition = t; time } :: taken)
          in
          try_ (List.map way ways @ others)
        in
        match happens with
        | (_, label) :: rest when Rat.sign wait = 0 -> go rest (candidates c state (Happens label))
        | [] when Rat.sign wait = 0 -> ends ()
        | _ -> (
            let successors = match Network.successors c state with Ok list -> numbered list | Error _ -> [] in
            let those test = List.find_opt (fun (_, (t : Transition.t)) -> test t.label) successors in
            match (those Transition.is_urgent, those Transition.is_time, happens) with
            | Some urgent, _, _ -> go happens [ urgent ]
            | None, Some ((_, t) as passes), _ when Rat.compare (Transition.duration t) wait <= 0 ->
              go happens [ passes ]
            | None, _, _ :: _ -> go happens (candidates c state (Passes_some wait))
            | None, _, [] -> ends ()))
  in
  try_ [ (start, Rat.zero, happens, []) ]

let arrived start (taken : Witness.step list) event =
  match taken with
  | [] -> false
  | { transition = { label; _ }; _ } :: before ->
    let source = match before with [] -> start | s :: _ -> s.transition.target in
    Event.matches ~source label event

let extent c state =
  match Time.delay c state with Some d -> Timeline.Lasts d | None -> Timeline.Forever

let holds c ~arrived state offset prop =
  let later = Rat.sign offset > 0 in
  let state, arrived = if later then (Time.pass c offset state, fun _ -> false) else (state, arrived) in
  let now = Trajectory.prop (Trajectory.make ~arrived c state Timeline.Instant) prop in
  Truth.equal now.Timeline.start Truth.True

let make given u ~declared ~sliced (run : Concrete.t) (place : Search_sets.place) : Witness.t =
  let m = Semantics.model given and prop = Scc_property.Rename.known run.values place.prop in
  let c = Semantics.with_model given (Fixed.model m run.values) in
  let start = initial c (Fixed.declared m u declared run.values) in
  let reached state taken offset = holds c ~arrived:(arrived start taken) state offset prop in
  let followed =
    match sliced with
    | false ->
      let reached state taken = reached state (List.rev taken) run.offset in
      follow c ~reached start run.steps
      |> Option.map (fun (last, steps) -> (last, steps, run.offset))
    | true ->
      let happens, until = instants run in
      interleave c ~reached start happens ~until
  in
  match followed with
  | None -> Bug.fail __POS__ "a run over zones does not replay"
  | Some (last, steps, after) ->
    let offset = Algebraic.of_rat after in
    let finish, extent =
      if Rat.sign after > 0 then
        let choice = match candidates c last (Passes_some after) with (i, _) :: _ -> Some i | [] -> None in
        (Witness.During { choice; offset; open_piece = false; from = offset }, extent c last)
      else (At_state, Timeline.Instant)
    in
    let arrived = arrived start (List.rev steps) in
    {
      initial = start;
      steps;
      last;
      finish;
      facts = Facts.at ~arrived c last extent offset prop;
      argument = None;
      fixed = Some { values = named m run.values; semantics = c };
      otherwise = None;
    }

(* {1 Runs that decide formulas} *)

let finish (r : Zone_established.t) (w : Shown_run.t) : Witness.finish =
  let steps = Array.to_list r.steps in
  let n = List.length steps in
  let last = Zone_established.state r n in
  let choice =
    match candidates r.semantics last (Passes_some w.run.offset) with (i, _) :: _ -> Some i | [] -> None
  in
  let after k = List.filteri (fun i _ -> i >= k) steps in
  match w.finish with
  | There when Rat.sign w.run.offset = 0 -> At_state
  | There ->
    let offset = Algebraic.of_rat w.run.offset in
    let from = match Zone_reasons.right_after r w.claim with Some d -> Algebraic.of_rat d | None -> offset in
    During { choice; offset; open_piece = not (Algebraic.equal from offset); from }
  | Rests -> Rests { puts_off = Make_witness.puts_off r.semantics [] ~from:last }
  | Passes bound ->
    let is_time (_, (t : Transition.t)) = Transition.is_time t.label in
    let successors = match Network.successors r.semantics last with Ok list -> numbered list | Error _ -> [] in
    let offset = Algebraic.of_rat (Rat.sub bound (Zone_established.clock r n)) in
    Witness.passes r.semantics ~choice:(Option.map fst (List.find_opt is_time successors)) offset last
  | Goes_on cycle -> Goes_on { cycle }
  | Repeats cycle -> (
      let from = Zone_established.state r cycle in
      let puts_off = Make_witness.puts_off r.semantics (after cycle) ~from in
      match Make_witness.moved from last with
      | Some moved -> Repeats { cycle; moved = Together moved; puts_off }
      | None -> Bug.fail __POS__ "a run over zones does not come back")

let of_run given u ~declared (w : Shown_run.t) : Witness.t =
  let m = Semantics.model given in
  let values = w.run.values in
  let c = Semantics.with_model given (Fixed.model m values) in
  let start = initial c (Fixed.declared m u declared values) in
  let followed steps = { Zone_established.semantics = c; values; initial = start; steps = Array.of_list steps } in
  let reached _ taken = Zone_established.claim (followed taken) w.claim in
  match follow c ~reached start w.run.steps with
  | None -> Bug.fail __POS__ "a run over zones does not show what it is to show"
  | Some (last, steps) ->
    let r = followed steps in
    {
      initial = start;
      steps;
      last;
      finish = finish r w;
      facts = Zone_reasons.facts r w.claim;
      argument = Zone_reasons.argument m r w.claim;
      fixed = Some { values = named m values; semantics = c };
      otherwise = None;
    }
