open Scc_semantics
open Scc_property
open Scc_state_space
open Scc_explain

let rec is_search (plan : Plan.t) =
  match plan with
  | Possibly (None, _) | Always (None, _) -> true
  | Now _ | Possibly (Some _, _) | Always (Some _, _) | Formula _ -> false
  | All plans | Any plans -> List.for_all is_search plans

let serves (c : Property.check) = is_search (Plan.of_formula c.formula)

let rec goals (plan : Plan.t) =
  match plan with
  | Possibly (_, p) -> [ p ]
  | Always (_, p) -> [ Formula.negate p ]
  | All plans | Any plans -> List.concat_map goals plans
  | Now _ | Formula _ -> []

(* Bounds that were met, the possible omission first among them, and faults. *)
let limits_met options model (r : Compact_search.result) =
  let omission : Verdict.truncation = { limit = Omission r.omission; origin = By_user } in
  let cause reason = Bounds.cause options.Setup.bounds model ~horizon:None reason in
  let causes = List.map cause r.left in
  let bounds = List.filter_map (function Bounds.Bound t -> Some t | Fault _ | Early -> None) causes in
  let faults = List.filter_map (function Bounds.Fault f -> Some f | Bound _ | Early -> None) causes in
  (omission :: bounds, List.sort_uniq Scc_base.Diag.compare faults)

(* Why a goal that was not met may be met all the same. *)
let doubts (bounds, faults) undefined : Verdict.reason list =
  List.map (fun why -> Verdict.Undefined why) (Option.to_list undefined)
  @ List.map (fun (f : Scc_base.Diag.t) -> Verdict.Fault f.message) faults
  @ List.map (fun t -> Verdict.Truncated t) bounds

let is_guard (t : Verdict.truncation) =
  match t.limit with
  | Instant _ -> true
  | Depth _ | Time _ | States _ | Draws _ | Bits _ | Seconds _ | Memory _ | Interrupted | Omission _ -> false

let search context lost met ~always p (answer : Compact_search.answer) : Verdict.t =
  match answer with
  | Met m ->
    let witness =
      Lost.run lost (Network_lts.semantics context) (fun () -> Some (Make_witness.of_met context p m))
    in
    if always then Violated { witness } else Holds { bounds = []; witness }
  | Unmet undefined ->
    let bounds, faults = met in
    let only_bounds = Option.is_none undefined && faults = [] && not (List.exists is_guard bounds) in
    if always && only_bounds then Holds { bounds; witness = None } else Undecided (doubts met undefined)

let rec verdict context lost met (plan : Plan.t) answers =
  let both combine plans =
    let step (found, answers) plan =
      let v, answers = verdict context lost met plan answers in
      (v :: found, answers)
    in
    let found, answers = List.fold_left step ([], answers) plans in
    (combine (List.rev found), answers)
  in
  match (plan, answers) with
  | Possibly (_, p), a :: rest -> (search context lost met ~always:false p a, rest)
  | Always (_, p), a :: rest -> (search context lost met ~always:true p a, rest)
  | All plans, _ -> both Verdict.conjunction plans
  | Any plans, _ -> both Verdict.disjunction plans
  | (Possibly _ | Always _ | Now _ | Formula _), _ ->
    Scc_base.Bug.fail __POS__ "what hash compaction does not serve"

let check (options : Setup.t) ~capacity semantics ~initial checks : Joint_check.result =
  let plans = List.map (fun (c : Property.check) -> Plan.of_formula c.formula) checks in
  (* The choice that led to a state is one of 255. *)
  let reductions = List.filter (fun k -> not (Reduction.equal k Draws)) options.reductions in
  let context = Joint_check.system { options with reductions } semantics ~initial checks plans in
  let goals = List.map (Predicate.make context) (List.concat_map goals plans) in
  let limits = Bounds.limits options.bounds ~horizon:None in
  let rests tuple = Network.quiescent semantics (Catalogue.decode (Network_lts.catalogue context) tuple) in
  let expanding = options.compacting ~about:(Joint_check.about checks) in
  let r = Compact_search.search ~expanding limits options.surroundings context ~capacity ~rests goals in
  let ((bounds, faults) as met) = limits_met options (Semantics.model semantics) r in
  let step (outcomes, answers) ((check, plan), share) =
    let shared = Setup.share options share in
    let lost = Lost.make shared.bounds shared.surroundings.attempt in
    let v, answers = verdict context lost met plan answers in
    ((check, v, Lost.taken lost) :: outcomes, answers)
  in
  let outcomes, _ =
    List.fold_left step ([], r.answers) (Setup.shares ~size:(fun _ -> 1) ~after:0 (List.combine checks plans))
  in
  {
    outcomes = List.rev outcomes;
    stats =
      {
        (* No events are looked at, and no path is kept. *)
        Stats.none with
        states = r.states;
        transitions = r.transitions;
        depth = r.depth;
        model_time = Some r.arrival;
        split_step = Network_lts.split_step context;
        decided_early = List.exists (function Scc_graph_search.Explore.Stopped -> true | _ -> false) r.left;
        stopped_by = bounds;
        faults;
        dead_ends = Bounds.dead_ends context;
        shared = Shared_edge.warning context;
      };
    zeno = None;
    lost = Lost.nothing;
    stores = [ ("states", r.bytes); ("labels", 0); ("edges", 0) ];
    numbers = (fun () -> Catalogue.longest (Network_lts.catalogue context));
  }
