open Scc_base
open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_space
open Scc_symbolic
open Scc_regions
open Scc_verify
open Zone_explored

let is_for = Left_open.leaves_open

type use = Zones | Graph | Invariants

let refused (m : Model.t) use =
  let what, fixed =
    match use with
    | Zones | Graph ->
      ("what is not known of this model does not stay linear", "give every parameter a value, and a `split_step`")
    | Invariants -> ("no invariant of this model can be looked for", "its checks can be explored, without --prove")
  in
  let because text hint = [ Diag.error Code.not_yet Span.none "%s: %s" what text ~hint ] in
  if Option.is_some m.rigid then because "its bodies turn" fixed
  else if Option.is_some m.round_velocity then because "its velocities are rounded" fixed
  else
    match (use, Zone_chance.refused m) with
    | Zones, Some (reason, instead) -> because reason instead
    | Zones, None -> []
    | (Graph | Invariants), _ when m.steered -> because "a law of motion steers its bodies" fixed
    | (Graph | Invariants), _ when m.lots ->
      because "splits of it are left to chance" "give every parameter a value"
    | (Graph | Invariants), _ -> []

type fault = { at : (string * Rat.t) list; reason : Start.reason }

let diagnostic (m : Model.t) { at; reason } =
  let values = Verdict.values_to_string at in
  match reason with
  | Interpenetrate ((a, i), (b, j)) ->
    let name leaf part = if a = b then m.leaves.(leaf).parts.(part).name else m.leaves.(leaf).name in
    Diag.error Code.interpenetration Span.none "`%s` and `%s` interpenetrate for some starts: for %s"
      (name a i) (name b j) values
  | Apart (one, two) ->
    let site (f : State.finish) = Model.site_name m ~leaf:f.at f.site in
    Diag.error Code.not_touching Span.none "%s and %s do not touch for some starts: for %s"
      (site one) (site two) values

(* {1 Verdicts} *)

let verdict options lost semantics u ~declared (e : Zone_explored.t) check answer (where : Where.t) : Verdict.t =
  let rebuilt make = Lost.run lost semantics make in
  let witness (place : Search_sets.place) =
    let sliced = Option.is_some e.group.part in
    Zone_witness.make semantics u ~declared ~sliced (Concrete.run e.graph place) place
  in
  let shown ~holds = rebuilt (fun () -> Option.map witness (Answers.shown_by answer ~holds)) in
  let run_of = Zone_witness.of_run semantics u ~declared in
  let run ~holds = rebuilt (fun () -> Option.map run_of (Answers.run answer e.graph ~holds)) in
  let first_some a b = match a with Some _ -> a | None -> b () in
  let bounded = List.map (fun t -> Verdict.Truncated t) e.stopped_by in
  let reasons =
    bounded
    @ List.map (fun r -> Verdict.Undefined r) (Answers.reasons answer)
    @ List.map (fun t -> Verdict.Unevaluated t)
      (if Answers.is_search answer then [] else Option.to_list e.unevaluated)
    @ List.map (fun r -> Verdict.Fault r) (Option.to_list e.fault)
  in
  if not (Union.is_empty where.fails) then
    let witness =
      match (shown ~holds:false, Union.point where.fails) with
      | (Some _ as w), _ -> w
      | None, Some values when not (Plan.is_search (Plan.of_formula check.Property.formula)) ->
        let of_start () = Zone_single.run options semantics u ~declared check values in
        first_some (rebuilt of_start) (fun () -> run ~holds:false)
      | None, _ -> None
    in
    Violated { witness }
  else if Union.is_empty where.unknown then
    Holds { bounds = []; witness = first_some (shown ~holds:true) (fun () -> run ~holds:true) }
  else if Answers.safe_so_far answer && List.length reasons = List.length e.stopped_by && reasons <> [] then
    Holds { bounds = e.stopped_by; witness = None }
  else
    let nearest =
      if e.stopped_by = [] then None
      else
        let sliced = Option.is_some e.group.part in
        Zone_nearest.reason lost semantics u ~declared ~sliced e.graph ~unknown:where.unknown
    in
    Undecided (reasons @ Option.to_list nearest)

let where ranges answer proof =
  let { Answers.holds; fails } = sets answer proof in
  Where.make ranges ~holds ~fails

(* Whether what was explored alone would not do. *)
let rests_on_proof answer (where : Where.t) (verdict : Verdict.t) =
  let { Answers.holds; fails } = Answers.sets answer in
  match verdict with
  | Holds { bounds = []; _ } -> not (Union.is_empty (Union.difference where.holds holds))
  | Violated _ -> Union.is_empty fails
  | Holds _ | Measured _ | Depends _ | Undecided _ -> false

(* A bound on its size has ended the exploration, or the seconds that it had of those who asked for an invariant,
   and something is not known that an invariant may prove. *)
let is_open ~asked ~exactly (e : Zone_explored.t) =
  let of_size (t : Verdict.truncation) =
    match t.limit with
    | Depth _ | States _ | Draws _ | Time _ -> true
    | Seconds _ -> asked
    | Instant _ | Bits _ | Memory _ | Interrupted | Omission _ -> false
  in
  let is_open (_, (c : Property.check)) answer =
    Proof.may_prove c.formula && not (Answers.is_known ~exactly answer)
  in
  e.stopped_by <> [] && List.for_all of_size e.stopped_by && List.exists2 is_open e.group.members e.answers

let stats (m : Model.t) (e : Zone_explored.t) : Stats.t =
  let deepest = ref 0 in
  for i = 0 to Zone_graph.size e.graph - 1 do
    deepest := Int.max !deepest (Zone_graph.node e.graph i).depth
  done;
  {
    Stats.none with
    states = Zone_graph.size e.graph;
    transitions = e.edges;
    depth = !deepest;
    complete = e.stopped_by = [] && e.fault = None && not e.decided;
    decided_early = e.decided;
    split_step = (match m.splits with Every step -> Some step | Any_time -> None);
    stopped_by = e.stopped_by;
    causes = Zone_causes.find m e;
  }

let slice m ~initial (e : Zone_explored.t) : Check.slice option =
  let of_part part =
    let names = List.map (fun (_, (c : Property.check)) -> c.name) e.group.members in
    {
      Check.properties = List.sort_uniq String.compare names;
      left_out = Slice.left_out m ~initial part;
      explored = stats m e;
    }
  in
  Option.map of_part e.group.part

let outcomes options semantics u ~declared ((e : Zone_explored.t), shares) =
  let m = Semantics.model semantics in
  let one ((i, check), share) (answer, proof) =
    let shared = Setup.share options share in
    let lost = Lost.make shared.bounds shared.surroundings.attempt in
    let where = where m.ranges answer proof in
    let verdict = verdict shared lost semantics u ~declared e check answer where in
    let example =
      match (verdict, Union.point where.fails) with
      | Violated { witness = None }, Some values -> Zone_single.named m values
      | _ -> []
    in
    let everywhere = Union.covers where.fails (Ranges.box m.ranges) in
    let by_invariant = rests_on_proof answer where verdict in
    let scale = Left_open.make semantics ~declared ~example ~everywhere ~by_invariant in
    let { Lost.faults; left_out } = Lost.taken lost in
    let left_out = Verdict.if_unshown verdict left_out in
    (i, { Verdict.check; verdict; scale; rests = []; converges = None; lost = faults; left_out }, where)
  in
  List.map2 one shares (List.combine e.answers (proofs_of e.answers e.proof))

(* What no run meets for any values is met never: of some values nothing is told. *)
let premises (m : Model.t) (e : Zone_explored.t) =
  let all = Ranges.box m.ranges in
  let one (i, check) answer =
    let never = Union.covers (Answers.sets answer).fails all in
    let verdict : Verdict.t = if never then Violated { witness = None } else Undecided [] in
    let scale = { Verdict.resolution = None; split_step = None; over = None } in
    (i, { Verdict.check; verdict; scale; rests = []; converges = None; lost = []; left_out = None })
  in
  List.map2 one e.group.premises e.met

(* The bounds of a search for an invariant after the exploration, by what the one before it came to. *)
let later ~some_check (before : By_invariant.end_ option) : By_invariant.effort option =
  match before with
  | None -> if some_check then Some Unasked else None
  | Some (Given_up _) -> Some Longer
  | Some (Proved _ | None_found _) -> None

(* Explores a group; the result searches for an invariant, where that is needed, when all are explored. *)
let of_group (options : Setup.t) semantics context u ~declared ~initial ~exactly (group : Zone_groups.t) =
  let m = Semantics.model semantics in
  let some_check = group.members <> [] in
  let attempt options effort =
    let declared = Option.value group.part ~default:declared in
    Result.to_option (By_invariant.attempt options effort semantics u ~declared (List.map snd group.members))
  in
  let before = if options.prove && some_check then attempt options Briefly else None in
  let of_zones zones =
    let within = By_invariant.leaving_time options before in
    let e = explore within context group ~initial zones ~ranges:m.ranges ~exactly ~proof:before in
    fun options ->
      match later ~some_check before with
      | Some effort when is_open ~asked:options.Setup.prove ~exactly e -> { e with proof = attempt options effort }
      | Some _ | None -> e
  in
  let initial = Option.value group.part ~default:initial in
  Result.map of_zones (Start.zones context u ~initial ~keeps_time:group.keeps_time)

(* The checks by the slice and the time that they need. What all slices leave out has to be well-formed as well. *)
let groups (options : Setup.t) context u ~initial ~premises checks =
  let bounded = Option.is_some (Bounds.value options.bounds.time) in
  let slicing =
    List.exists (Reduction.equal Slice) options.reductions && Array.length initial.State.processes > 1
  in
  if not slicing then Ok (Zone_groups.make ~bounded ~part:(fun _ -> None) ~premises checks)
  else
    let formulas (c : Property.check) =
      let of_it = List.filter (fun (p : Property.check) -> String.equal p.name c.name) premises in
      List.map (fun (c : Property.check) -> c.formula) (c :: of_it)
    in
    let part zones c = Zone_slice.make context u ~initial (List.hd zones) (formulas c) in
    Start.zones context u ~initial ~keeps_time:false
    |> Result.map (fun zones -> Zone_groups.make ~bounded ~part:(part zones) ~premises checks)

(* The explorations, each with the shares of its checks. *)
let concluding ~after explored =
  let later (e : Zone_explored.t) (after, found) =
    let shares = Setup.shares ~size:(fun _ -> 1) ~after e.group.members in
    (after + List.length shares, (e, shares) :: found)
  in
  snd (List.fold_right later explored (after, []))

(* A group that is explored, and the verdicts of its checks with their numbers. *)
type concluded = { explored : Zone_explored.t; found : (int * Verdict.outcome * Where.t) list }

let concluded options semantics u ~declared ~after explored =
  let one ((e, _) as with_shares) =
    { explored = e; found = outcomes options semantics u ~declared with_shares }
  in
  List.map one (concluding ~after explored)

let had_share c = List.exists (fun (_, (o : Verdict.outcome), _) -> Verdict.had_share o.verdict) c.found

let report semantics ~initial concluded : Check.report =
  let m = Semantics.model semantics in
  let explored = List.map (fun c -> c.explored) concluded in
  let sorted =
    List.concat_map (fun c -> c.found) concluded |> List.sort (fun (i, _, _) (j, _, _) -> Int.compare i j)
  in
  let by_number l = List.map snd (List.sort (fun (i, _) (j, _) -> Int.compare i j) l) in
  let stats = List.map (stats m) explored in
  {
    outcomes = List.map (fun (_, o, _) -> o) sorted @ by_number (List.concat_map (premises m) explored);
    stats = List.fold_left Stats.add (List.hd stats) (List.tl stats);
    uneventful = List.exists (fun (e : Zone_explored.t) -> e.uneventful) explored;
    slices = List.filter_map (slice m ~initial) explored;
    zeno = None;
    lost = [];
    left_out = None;
    stores = [];
    where = List.map (fun (_, _, w) -> w) sorted;
    invariants = List.filter_map (fun (e : Zone_explored.t) -> e.proof) explored;
    numbers = (fun () -> []);
  }

(* [after] other checks come next. *)
let without_chance (options : Setup.t) semantics context u ~declared ~initial ~exactly ~premises ~after checks =
  (* All are explored before an invariant is searched for, so that no search takes the time of another check. *)
  let explored =
    let* groups = groups options context u ~initial ~premises checks in
    let shares = Setup.shares ~size:(fun (g : Zone_groups.t) -> List.length g.members) ~after groups in
    let explore (group, share) =
      of_group (Setup.share options share) semantics context u ~declared ~initial ~exactly group
      |> Result.map (fun proved -> (proved, share))
    in
    Result.all explore shares
  in
  match explored with
  | Error { Start.at; reason } -> Error { at; reason }
  | Ok explored ->
    let proved = List.map (fun (proved, share) -> proved (Setup.share options share)) explored in
    Ok (concluded options semantics u ~declared ~after proved)

(* What its share has ended begins anew with the seconds that all others have left. *)
let anew (options : Setup.t) semantics context u ~declared ~initial ~exactly all =
  let run options (group : Zone_groups.t) =
    of_group options semantics context u ~declared ~initial ~exactly group
    |> Result.map (fun proved -> List.hd (concluded options semantics u ~declared ~after:0 [ proved options ]))
  in
  let is_over () = Option.is_some (options.surroundings.stop ()) in
  let cut, kept = List.partition had_share all in
  if cut = [] || is_over () then Ok all
  else
    List.map (fun c -> c.explored.group) cut
    |> Setup.in_rounds options ~size:(fun (g : Zone_groups.t) -> List.length g.members)
      ~cut:(function Ok c -> had_share c | Error _ -> false)
      run
    |> Result.all Fun.id
    |> Result.map (fun again -> again @ kept)

(* {1 Chance} *)

(* Verdicts of checks that need probabilities. Those about the same untils have one share of the seconds. *)
let by_chance options semantics u ~declared checks =
  let context = Instant.context semantics in
  let of_check options shared (check : Property.check) =
    let found (r : Zone_chance.result) =
      let example =
        match (r.verdict, Union.point r.where.fails) with
        | Violated _, Some values -> Zone_single.named (Semantics.model semantics) values
        | _ -> []
      in
      let everywhere = Union.covers r.where.fails (Ranges.box r.where.ranges) in
      let scale = Left_open.make semantics ~declared ~example ~everywhere ~by_invariant:false in
      let outcome =
        { Verdict.check; verdict = r.verdict; scale; rests = []; converges = None; lost = []; left_out = None }
      in
      (outcome, r)
    in
    Result.map found (Zone_chance.check options shared semantics context u ~declared check)
  in
  let of_group options group =
    let shared = Zone_chance.shared (List.map snd group) in
    Result.all (fun (i, c) -> Result.map (fun found -> (i, found)) (of_check options shared c)) group
  in
  let cut = function
    | Ok found -> List.exists (fun (_, ((o : Verdict.outcome), _)) -> Verdict.had_share o.verdict) found
    | Error _ -> false
  in
  Zone_chance.groups checks
  |> Setup.in_rounds options ~size:List.length ~cut of_group
  |> Result.all Fun.id
  |> Result.map (fun found ->
      List.concat found |> List.sort (fun (i, _) (j, _) -> Int.compare i j) |> List.map snd)

(* Nothing is told of premises here. *)
let untold (check : Property.check) : Verdict.outcome =
  let scale = { Verdict.resolution = None; split_step = None; over = None } in
  { check; verdict = Undecided []; scale; rests = []; converges = None; lost = []; left_out = None }

let nothing : Check.report =
  {
    outcomes = []; stats = { Stats.none with decided_early = false; complete = true };
    uneventful = false; slices = []; zeno = None;
    lost = []; left_out = None; stores = []; where = []; invariants = []; numbers = (fun () -> []);
  }

(* The elements of two lists in the order of a third one, whose elements tell which list the next one is from. *)
let interleaved from_first firsts seconds order =
  let take (found, firsts, seconds) x =
    match (from_first x, firsts, seconds) with
    | true, y :: firsts, _ -> (y :: found, firsts, seconds)
    | false, _, y :: seconds -> (y :: found, firsts, seconds)
    | true, [], _ | false, _, [] -> Bug.fail __POS__ "a check without a verdict"
  in
  let found, _, _ = List.fold_left take ([], firsts, seconds) order in
  List.rev found

let run options semantics u ~declared ~exactly ~premises checks =
  let m = Semantics.model semantics in
  let serves = Zone_chance.serves m in
  let drawn, others = List.partition serves checks in
  let is_drawn (p : Property.check) = List.exists (fun (c : Property.check) -> String.equal c.name p.name) drawn in
  let of_drawn, of_others = List.partition is_drawn premises in
  let context = Instant.context semantics and initial = By_invariant.initial semantics declared in
  let explored =
    if others = [] && (drawn <> [] || Zone_chance.serves_all m) then Ok None
    else
      let after = List.length drawn in
      without_chance options semantics context u ~declared ~initial ~exactly ~premises:of_others ~after others
      |> Result.map Option.some
  in
  let both =
    let* explored = explored in
    let* found =
      Result.map_error (fun { Start.at; reason } -> { at; reason }) (by_chance options semantics u ~declared drawn)
    in
    match explored with
    | None -> Ok (nothing, found)
    | Some explored ->
      anew options semantics context u ~declared ~initial ~exactly explored
      |> Result.map (fun explored -> (report semantics ~initial explored, found))
      |> Result.map_error (fun { Start.at; reason } -> { at; reason })
  in
  match both with
  | Error fault -> Error fault
  | Ok ((report : Check.report), found) ->
    let n = List.length others in
    let of_checks = List.filteri (fun i _ -> i < n) report.outcomes in
    let of_premises = List.filteri (fun i _ -> i >= n) report.outcomes in
    let outcomes =
      interleaved serves (List.map fst found) of_checks checks
      @ interleaved is_drawn (List.map untold of_drawn) of_premises premises
    in
    let found_where = List.map (fun (_, (r : Zone_chance.result)) -> r.where) found in
    let where = interleaved serves found_where report.where checks in
    let all = List.map (fun (_, (r : Zone_chance.result)) -> r.stats) found in
    Ok { report with outcomes; where; stats = List.fold_left Stats.add report.stats all }
