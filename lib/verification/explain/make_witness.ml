open Scc_ctl
open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_evaluate
open Scc_state_space
module Graph = State_graph

(** {2 Runs that come back} *)

let rec drop n l = match l with _ :: rest when n > 0 -> drop (n - 1) rest | _ -> l

let at_time time (s : State.t) = State.at ~step:s.step ~time s

(* By how much a state is the other one moved as a whole, whatever time it is: the two stand for one state of the
   graph, so that nobody who asks can tell their times apart. *)
let moved (from : State.t) (state : State.t) =
  match (from.processes, state.processes) with
  | [||], _ | _, [||] -> if State.equal (at_time state.time from) state then Some Vec.zero else None
  | ps, qs ->
    let by = Vec.sub qs.(0).leaves.(0).position ps.(0).leaves.(0).position in
    let move (l : State.leaf) = { l with position = Vec.add l.position by } in
    let processes = List.map (State.map_leaves move) (Array.to_list ps) in
    let there = State.make ~processes ~step:from.step ~time:state.time in
    if State.equal there state then Some by else None

(* What a round that leads from the one state to the other moves. *)
let apart context (from : State.t) (state : State.t) =
  let place (p : State.process) = p.leaves.(0).position in
  let by i (p : State.process) = (p.leaves.(0).leaf, Vec.sub (place state.processes.(i)) (place p)) in
  if Network_lts.same_but_for_places context from state then
    Some (Witness.Apart (List.mapi by (Array.to_list from.processes)))
  else None

let what_moved context from state =
  match moved from state with Some by -> Some (Witness.Together by) | None -> apart context from state

(* A round on the graph may lead to another state than it began in, one that the same state of the graph
   stands for: it is made again until a state recurs, where it was or somewhere else. Where only names
   change, that is when names that bodies took of each other are back: after the order of a permutation,
   which is 5460 at most for 32 bodies that are alike. Where several ways from a state are images of each
   other, rounds may never lead back to the first state, but to one that was met since. So the state after
   every 2^k rounds is compared as well (Brent). *)
let most_rounds = 100_000

let follow_lasso context along steps cycle =
  let stem = List.filteri (fun i _ -> i < cycle) steps and round = drop cycle steps in
  let entry = along (Followed.start context) stem in
  let rec again n ~(met : Followed.t) from =
    let next : Followed.t = along from round in
    let back_to (earlier : Followed.t) =
      let back moved = (next, moved, List.length earlier.steps) in
      Option.map back (what_moved context earlier.last next.last)
    in
    match List.find_map back_to [ entry; met ] with
    | Some found -> found
    | None when n >= most_rounds -> Bug.fail __POS__ "a round that never comes back"
    | None -> again (n + 1) ~met:(if n land (n - 1) = 0 then next else met) next
  in
  again 1 ~met:entry entry

(* A weak split that is enabled somewhere on a cycle and never made on it. *)
let puts_off semantics (cycle : Witness.step list) ~from =
  let made = List.map (fun (s : Witness.step) -> s.transition.label) cycle in
  let is_put_off (t : Transition.t) =
    match t.label with
    | Weak_split _ when not (List.exists (Transition.equal_label t.label) made) -> Some t.label
    | Weak_split _ | Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Strong_split _ | Draw _ | Lot _ -> None
  in
  let at state =
    match Network.successors semantics state with
    | Ok transitions -> List.find_map is_put_off transitions
    | Error _ -> None
  in
  List.find_map at (from :: List.map (fun (s : Witness.step) -> s.transition.target) cycle)

(* [cycle] is the number of steps before the round. *)
let repeats context ((run : Followed.t), moved, cycle) : Witness.finish =
  let steps = List.rev run.steps in
  let from =
    match if cycle = 0 then None else List.nth_opt steps (cycle - 1) with
    | Some s -> s.Witness.transition.target
    | None -> Network_lts.start context
  in
  Repeats { cycle; moved; puts_off = puts_off (Network_lts.semantics context) (drop cycle steps) ~from }

(* Time passes in at most one way from a state. *)
let time_choice context state =
  match Network.successors (Network_lts.semantics context) state with
  | Error _ -> None
  | Ok transitions ->
    let rec find k = function
      | [] -> None
      | (t : Transition.t) :: rest -> (
          match t.label with
          | Time d -> Some (k, d)
          | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ ->
            find (k + 1) rest)
    in
    find 0 transitions

let extent context state =
  match time_choice context state with
  | Some (_, d) -> Timeline.Lasts d
  | None -> Timeline.Forever

let witness context (run : Followed.t) finish facts : Witness.t =
  {
    initial = Network_lts.start context;
    steps = List.rev run.steps;
    last = run.last;
    finish;
    facts;
    argument = None;
    fixed = None;
    otherwise = None;
  }

let during context state (moment : Timeline.moment) sample : Witness.finish =
  let choice = Option.map fst (time_choice context state) in
  During { choice; offset = sample; open_piece = not moment.attained; from = moment.offset }

let no_facts _ _ _ = []

let of_trace context graph predicate (trace : Search.trace) =
  let facts =
    match predicate with
    | None -> no_facts
    | Some p ->
      let tuple = Graph.tuple graph trace.last in
      let arrived event = Network_lts.arrived context event tuple in
      fun state extent offset -> Facts.at ~arrived (Network_lts.semantics context) state extent offset p
  in
  match trace.finish with
  | At_state ->
    let run = Followed.along context graph (Followed.start context) trace.steps in
    witness context run At_state (facts run.last Timeline.Instant Algebraic.zero)
  | During { moment; sample; _ } ->
    let run = Followed.along context graph (Followed.start context) trace.steps in
    let finish = during context run.last moment sample in
    witness context run finish (facts run.last (extent context run.last) sample)
  | Repeats cycle ->
    let ((run, _, _) as lasso) = follow_lasso context (Followed.along context graph) trace.steps cycle in
    witness context run (repeats context lasso) (facts run.last Timeline.Instant Algebraic.zero)

(* The tuples that choices lead through, from the initial one. *)
let targets context choices =
  let step (tuple, acc) choice =
    match Network_lts.successors context tuple with
    | Error _ -> Bug.fail __POS__ "a run does not replay: a fault on its way"
    | Ok steps ->
      let next = Scc_graph_search.Tuples.apply (List.nth steps choice).changes tuple in
      (next, (choice, next) :: acc)
  in
  let last, reached = List.fold_left step (Network_lts.initial context, []) choices in
  (last, List.rev reached)

let on context = List.fold_left (fun from (choice, target) -> Followed.step context from choice target)

let of_cycle context choices ~from =
  let _, reached = targets context choices in
  let ((run, _, _) as lasso) = follow_lasso context (on context) reached from in
  witness context run (repeats context lasso) []

let of_met context p (met : Compact_search.met) =
  let last, reached = targets context met.choices in
  let run = on context (Followed.start context) reached in
  let arrived event = Network_lts.arrived context event last in
  let facts extent offset = Facts.at ~arrived (Network_lts.semantics context) run.last extent offset p in
  match met.during with
  | None -> witness context run At_state (facts Timeline.Instant Algebraic.zero)
  | Some (moment, sample) ->
    witness context run (during context run.last moment sample) (facts (extent context run.last) sample)

let of_path context graph i =
  of_trace context graph None { steps = Graph.shortest_path graph i; last = i; finish = At_state }

(** {2 Explanations} *)

let steps_of temporal (run : Scc_ctl.Run.t) = List.map (Temporal.choice temporal) run.steps

let of_run context graph temporal (run : Scc_ctl.Run.t) =
  let steps = steps_of temporal run in
  match run.finish with
  | Repeats cycle ->
    let ((followed, _, _) as lasso) = follow_lasso context (Followed.along context graph) steps cycle in
    witness context followed (repeats context lasso) []
  | At_state | During _ | Rests | Stops | Passes _ ->
    let followed = Followed.along context graph (Followed.start context) steps in
    let finish : Witness.finish =
      match run.finish with
      | At_state | Repeats _ -> At_state
      | During { moment; sample } -> during context followed.last moment sample
      | Rests -> Rests { puts_off = None }
      | Stops -> Stops
      | Passes offset ->
        let choice = Option.map fst (time_choice context followed.last) in
        Witness.passes (Network_lts.semantics context) ~choice offset followed.last
    in
    witness context followed finish []

let of_explanation context graph temporal e =
  Option.map
    (fun run ->
       let w = of_run context graph temporal run in
       let facts = Wording.facts context graph temporal ~last:w.last e in
       { w with Witness.facts; argument = Wording.argument context graph temporal e })
    (Explanation.chain e)

(* A step of the graph may be several of a run: those in common are counted again. *)
let with_contrast context graph temporal e (w : Witness.t) =
  let shared (other : Witness.t) =
    let rec count n (a : Witness.step list) (b : Witness.step list) =
      match (a, b) with
      | x :: a, y :: b when Int.equal x.choice y.choice && Rat.equal x.time y.time -> count (n + 1) a b
      | _ -> n
    in
    count 0 w.steps other.steps
  in
  let made (explanation, _) =
    Option.map
      (fun run ->
         let other = of_run context graph temporal run in
         let facts = Wording.facts context graph temporal ~last:other.last explanation in
         { Witness.shared = shared other; run = { other with facts } })
      (Explanation.chain explanation)
  in
  { w with otherwise = Option.bind (Temporal.contrast temporal e) made }
