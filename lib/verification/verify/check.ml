open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_space
open Scc_explain

type slice = { properties : string list; left_out : string list; explored : Stats.t }

type report = {
  outcomes : Verdict.outcome list;
  stats : Stats.t;
  uneventful : bool;
  slices : slice list;
  zeno : Witness.t option;
  lost : string list;
  left_out : Verdict.truncation option;
  stores : (string * int) list;
  where : Scc_regions.Where.t list;
  invariants : By_invariant.end_ list;
  numbers : unit -> (string * int) list;
}

(** {2 Which properties go together} *)

(* What properties of one exploration have in common. One that tells all times apart, or all distances of bodies
   that drift apart, makes a finite exploration endless for the others. What else one property tells apart (events,
   names of leaves, places) is told apart for all: as a rule it costs less than an exploration more. *)
type needs = {
  part : State.t option;  (** the part of the network that does for them; [None]: all of it *)
  compact : int option;  (** with hash compaction *)
  time_seen : Time_seen.t;  (** of this kind: the greatest constant is that of all together *)
  far : bool;  (** it tells places apart however far bodies are from each other *)
}

let equal_needs a b =
  Option.equal State.equal a.part b.part
  && Option.equal Int.equal a.compact b.compact
  && Time_seen.same_kind a.time_seen b.time_seen
  && Bool.equal a.far b.far

(* Some properties, by their places in the list of all. *)
type group = {
  needs : needs;
  members : (int * Property.check) list;  (** the last first *)
}

let groups (options : Setup.t) semantics ~initial checks =
  let model = Semantics.model semantics in
  let slice = Slice.make semantics ~initial in
  let part (c : Property.check) =
    if List.exists (Reduction.equal Slice) options.reductions then slice [ c.formula ] else None
  in
  (* Times are not passed on there, so that a bound on them cannot be kept. *)
  let timeless = match options.bounds.time with Unbounded -> true | Default _ | Given _ -> false in
  let compact c = if timeless && Compact_check.serves c then options.compact else None in
  let needs (c : Property.check) =
    {
      part = part c;
      compact = compact c;
      time_seen = Reduction.time_seen options.reductions model [ c ];
      far = Reduction.sees_far options.reductions model initial [ c ];
    }
  in
  let join needs member =
    let joined g = if equal_needs g.needs needs then Some { g with members = member :: g.members } else None in
    Scc_data.Lists.put joined { needs; members = [ member ] }
  in
  match checks with
  | [] -> [ { needs = { part = None; compact = None; time_seen = Never; far = false }; members = [] } ]
  | _ :: _ ->
    List.fold_left (fun (i, groups) c -> (i + 1, join (needs c) (i, c) groups)) (0, []) checks |> snd

(** {2 Back to the whole} *)

let lift semantics ~initial (w : Witness.t) : Witness.t =
  match w.finish with
  | At_state | During _ -> Lift.timed semantics ~initial w
  | Repeats r ->
    (* The cycle takes no time: what is left out has nothing to do in it. *)
    let lifted = Lift.timed semantics ~initial { w with finish = At_state } in
    let more = List.length lifted.steps - List.length w.steps in
    { lifted with finish = Repeats { r with cycle = r.cycle + more } }
  | Rests _ | Stops | Passes _ | Goes_on _ -> Scc_base.Bug.fail __POS__ "a search that ends in no instant"

(* A slice does for the whole up to the horizon of its properties; a run that goes on from there is not one of the
   whole, and is not shown. *)
let lift_in_time semantics ~initial horizon w =
  let in_time = match horizon with None -> true | Some h -> Rat.compare (Witness.time w) h <= 0 in
  if in_time then Some (lift semantics ~initial w) else None

let lift_reason lift (r : Verdict.reason) : Verdict.reason option =
  match r with
  | Unexplored { count; nearest } ->
    Option.map (fun nearest -> Verdict.Unexplored { count; nearest }) (lift nearest)
  | Truncated _ | Unevaluated _ | Undefined _ | Fault _ -> Some r

let lift_verdict lift (v : Verdict.t) : Verdict.t =
  match v with
  | Holds { bounds; witness } -> Holds { bounds; witness = Option.bind witness lift }
  | Violated { witness } -> Violated { witness = Option.bind witness lift }
  | Depends _ -> v
  | Measured m ->
    Measured
      { m with reasons = List.filter_map (lift_reason lift) m.reasons; witness = Option.bind m.witness lift }
  | Undecided reasons -> Undecided (List.filter_map (lift_reason lift) reasons)

(** {2 All explorations} *)

let sum_stores a b =
  List.map (fun ((name : string), n) -> (name, n + Option.value (List.assoc_opt name b) ~default:0)) a

let most a b =
  List.map (fun ((name : string), n) -> (name, Int.max n (Option.value (List.assoc_opt name b) ~default:0))) a

(* What a verdict rests on that is about runs in which time does not go on. A run that meets what a search looks
   for is decisive up to there, however it goes on; a formula may speak of what comes after the last state. *)
let rests semantics (result : Joint_check.result) (check : Property.check) (v : Verdict.t) =
  let dead_ends = match result.stats.dead_ends with [] -> false | _ :: _ -> true in
  let by (w : Witness.t) =
    match (Witness.halt w, w.finish) with
    | Some halt, _ -> [ Verdict.By halt ]
    | None, At_state
      when dead_ends
        && (not (Plan.is_search (Plan.of_formula check.formula)))
        && Network_lts.is_dead_end semantics w.last ->
      [ By Dead_end ]
    | None, _ -> []
  in
  (* Fewer runs break no quantifier over all of them, and give nothing to one over some. But a run that was
     given up would have gone on somehow. *)
  let unless_lasting kind =
    let round = Option.to_list (Option.bind result.zeno Witness.halt) in
    let lasting = not (Formula.quantifies kind check.formula) in
    (if dead_ends then [ Verdict.Among Dead_end ] else [])
    @ List.filter_map (fun halt -> if lasting then None else Some (Verdict.Among halt)) round
  in
  match v with
  | Undecided _ | Measured _ | Depends _ -> []
  | Holds { witness = Some w; _ } | Violated { witness = Some w } -> by w
  | Holds { witness = None; _ } -> unless_lasting Exists
  | Violated { witness = None } -> unless_lasting All

(* What a bound left open may lie beyond the times that a run converges to. *)
let converges (result : Joint_check.result) v =
  match Verdict.truncated v with [] -> None | _ :: _ -> result.stats.converges

let explored (options : Setup.t) semantics ~initial group =
  let members = List.rev group.members in
  let whole = Option.is_none group.needs.part in
  let part = Option.value group.needs.part ~default:initial in
  let check =
    match group.needs.compact with
    | None -> Joint_check.check options
    | Some capacity -> Compact_check.check options ~capacity
  in
  let result = check semantics ~initial:part (List.map snd members) in
  let lost = Lost.make options.bounds options.surroundings.attempt in
  let horizon = Joint_check.horizon (List.map snd members) in
  let lift w = Lost.run lost semantics (fun () -> lift_in_time semantics ~initial horizon w) in
  let outcome (i, check) (_, v, of_part) =
    let verdict = if whole then v else lift_verdict lift v in
    let { Lost.faults; left_out } = Lost.together of_part (Lost.taken lost) in
    let split_step = match v with Verdict.Undecided _ -> None | Holds _ | Violated _ | Measured _ | Depends _ ->
      result.stats.split_step in
    let resolution = Model.resolution (Semantics.model semantics) in
    (* It may be that of one run that decides. *)
    let left_out = Verdict.if_unshown verdict left_out in
    let all_shown = faults = [] && Option.is_none left_out in
    let rests = if all_shown then rests semantics result check v else [] and converges = converges result v in
    let scale = { Verdict.resolution; split_step; over = None } in
    (i, { Verdict.check; verdict; scale; rests; converges; lost = faults; left_out })
  in
  let outcomes = List.map2 outcome members result.outcomes in
  let slice part =
    {
      properties = List.sort_uniq String.compare (List.map (fun (_, (c : Property.check)) -> c.name) members);
      left_out = Slice.left_out (Semantics.model semantics) ~initial part;
      explored = result.stats;
    }
  in
  let zeno = if whole then result.zeno else Option.bind result.zeno lift in
  let lost = Lost.together result.lost (Lost.taken lost) in
  (outcomes, Option.map slice group.needs.part, { result with zeno; lost })

let merge parts ~events_elsewhere =
  let outcomes = List.concat_map (fun (outcomes, _, _) -> outcomes) parts in
  let results = List.map (fun (_, _, (r : Joint_check.result)) -> r) parts in
  let slices = List.filter_map (fun (_, slice, _) -> slice) parts in
  match results with
  | [] -> Scc_base.Bug.fail __POS__ "nothing was explored"
  | first :: rest ->
    let stats = List.fold_left (fun s (r : Joint_check.result) -> Stats.add s r.stats) first.stats rest in
    let stores = List.fold_left (fun s (r : Joint_check.result) -> sum_stores s r.stores) first.stores rest in
    let in_order = List.sort (fun (i, _) (j, _) -> Int.compare i j) outcomes in
    (* Whoever has explored the whole network, and all of it, knows; slices know of what they keep. *)
    let knows (_, slice, (r : Joint_check.result)) =
      Option.is_none slice && r.stats.complete && not r.stats.eventful
    in
    let together_know () =
      stats.complete && (not stats.eventful) && not (List.length slices > 0 && events_elsewhere ())
    in
    {
      outcomes = List.map snd in_order;
      stats;
      uneventful = List.exists knows parts || together_know ();
      slices;
      zeno = List.find_map (fun (r : Joint_check.result) -> r.zeno) results;
      lost = List.concat_map (fun (r : Joint_check.result) -> r.lost.faults) results;
      left_out = List.find_map (fun (r : Joint_check.result) -> r.lost.left_out) results;
      stores;
      where = [];
      invariants = [];
      numbers =
        (fun () ->
           List.fold_left (fun n (r : Joint_check.result) -> most n (r.numbers ())) (first.numbers ()) rest);
    }

let whole options semantics ~initial checks =
  let events_elsewhere () = Joint_check.may_have_events options semantics ~initial in
  let run options group = explored options semantics ~initial group in
  let had_share (_, (o : Verdict.outcome)) = Verdict.had_share o.verdict in
  let cut (outcomes, _, _) = List.exists had_share outcomes in
  groups options semantics ~initial checks
  |> Setup.in_rounds options ~size:(fun g -> List.length g.members) ~cut run
  |> merge ~events_elsewhere

(* The model and where it starts, with movement steps as part of the state where they are not jumped over. *)
let stepping (options : Setup.t) semantics ~(initial : State.t) =
  let model = Semantics.model semantics in
  let stepwise = Reduction.without_jumps options.reductions model in
  if Bool.equal stepwise.steered model.steered then (semantics, initial)
  else
    let step = Some { State.remaining = model.timestep; phase = Steered } in
    ( Semantics.with_model semantics stepwise,
      State.at ~step ~time:initial.time initial )

let run options semantics ~initial checks =
  let semantics, initial = stepping options semantics ~initial in
  whole options semantics ~initial checks

type exploration = {
  semantics : Semantics.t;
  start : State.t;
  members : Property.check list;
  left_out : string list;
  lift : Witness.t -> Witness.t option;
}

let explorations (options : Setup.t) semantics ~initial checks =
  let semantics, initial = stepping options semantics ~initial in
  let of_group (g : group) =
    let members = List.rev_map snd g.members in
    let whole = { semantics; start = initial; members; left_out = []; lift = Option.some } in
    match g.needs.part with
    | None -> whole
    | Some start ->
      let left_out = Slice.left_out (Semantics.model semantics) ~initial start in
      let lift = lift_in_time semantics ~initial (Joint_check.horizon members) in
      { whole with start; left_out; lift }
  in
  List.map of_group (groups { options with compact = None } semantics ~initial checks)

let unexplored_report outcomes stats =
  {
    outcomes;
    stats;
    uneventful = false;
    slices = [];
    zeno = None;
    lost = [];
    left_out = None;
    stores = [];
    where = [];
    invariants = [];
    numbers = (fun () -> []);
  }

let unexplored (options : Setup.t) (checks : Property.check list) stop =
  let stopped = Bounds.stopped options.bounds stop in
  let outcome check =
    let scale = { Verdict.resolution = None; split_step = None; over = None } in
    let verdict = Verdict.Undecided [ Truncated stopped ] in
    { Verdict.check; verdict; scale; rests = []; converges = None; lost = []; left_out = None }
  in
  unexplored_report (List.map outcome checks)
    { Stats.none with decided_early = false; stopped_by = [ stopped ] }

let faults report =
  List.concat_map (fun (o : Verdict.outcome) -> o.lost) report.outcomes @ report.lost
  |> List.sort_uniq String.compare

let run_without options semantics ~initial checks ~decided =
  let rest = List.filter (fun c -> decided c = None) checks in
  let report = if rest = [] then unexplored_report [] Stats.none else run options semantics ~initial rest in
  let explored = List.combine rest report.outcomes in
  let outcome c = match decided c with Some outcome -> outcome | None -> List.assq c explored in
  { report with outcomes = List.map outcome checks }
