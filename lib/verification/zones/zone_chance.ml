open Scc_base
open Scc_exact
open Scc_polyhedra
open Scc_chance
open Scc_graph_search
open Scc_calculus
open Scc_state_sets
open Scc_semantics
open Scc_property
open Scc_symbolic
open Scc_regions
open Scc_verify
open Chance_work

let serves_all (m : Model.t) = Model.decides_by_chance m || m.steered

let serves m (check : Property.check) =
  serves_all m
  || Formula.asks_probability check.formula
  || match check.asked with Whether -> false | How_likely _ | Expected _ -> true

let refused (m : Model.t) =
  let value = "give every parameter a value, by `-D` or, for many starts, by `scc sweep -D x=0:3:1/2`" in
  if Model.of_each m then Some ("processes have movement steps of their own (`timestep ... local`)", value)
  else if Model.stops_walkers m then
    Some
      ( "walkers stop where they are blocked (rule Blocked: a kick is taken or not by all that lies on its path)",
        value ^ "; or let walkers bounce, `blocked bounce`" )
  else if Model.draws_ties m then Some ("chance decides which of several events comes first (rule Ties)", value)
  else if m.lots && m.splits = Any_time then
    Some ("splits at any time are left to chance (rule Lot)", "give a `split_step`")
  else None

type shared = Chance_work.shared

let shared = Chance_work.shared
let groups = Chance_work.groups

(* {1 Values} *)

let flipped : [ `Least | `Greatest ] -> [ `Least | `Greatest ] = function `Least -> `Greatest | `Greatest -> `Least

(* The values of an operator, of which it is asked how it is at least or at most. *)
let pieces w graph { Zone_question.negated; _ } ~chance side =
  let choice = if negated then flipped side else side in
  let chance = if chance then `Mean else (choice :> [ `Mean | `Least | `Greatest ]) in
  let mode = { Chance_value.choice; chance } in
  let most = most_layers w graph and parameters = Array.length w.ranges in
  let f = Chance_value.solve ~most ~progress:(valued w) graph mode ~parameters in
  let known = function
    | p, Some (v : Piecewise.value) ->
      if negated then (p, { Piecewise.least = Rat.sub Rat.one v.most; most = Rat.sub Rat.one v.least }) else (p, v)
    | _, None -> Bug.fail __POS__ "a start without a value"
  in
  List.map known (Piecewise.pieces (box w) f)

let side : Property.side -> [ `Least | `Greatest ] = function Least -> `Least | Greatest -> `Greatest

type sets = { holds : Union.t; fails : Union.t }

let by_test w pieces test =
  let n = Array.length w.ranges in
  let truth (_, (v : Piecewise.value)) =
    match (Answer.holds (Exact v.least) test, Answer.holds (Exact v.most) test) with
    | Some a, Some b when Bool.equal a b -> Some a
    | _ -> None
  in
  let those wanted =
    let is piece = Option.equal Bool.equal (truth piece) (Some wanted) in
    Union.of_polyhedra n (List.map fst (List.filter is pieces))
  in
  { holds = those true; fails = those false }

let surely : Answer.bound = { relation = At_least_so; than = Rat.one }

let of_operator w (o : Zone_question.operator) =
  let pieces = pieces w (explore w o.until) o in
  match o.quantifier with
  | All -> by_test w (pieces ~chance:false `Least) surely
  | Exists -> by_test w (pieces ~chance:false `Greatest) surely
  | Chance { side = s; test } -> by_test w (pieces ~chance:true (side s)) test

(* At the start. *)
let now w p =
  let formula = Property.State p in
  let events = Array.of_list (Formula.events formula) in
  let truth = Atoms.truth (Atoms.context w.context ~events) p in
  let look zone = truth { Atoms.zone; passing = false; quiescent = [] } in
  let all = List.concat_map look (zones w ~keeps_time:true) in
  let those wanted =
    let is (p, truth) = if Scc_ctl.Truth.equal truth wanted then Some p else None in
    Union.of_polyhedra (Array.length w.ranges) (List.filter_map is all)
  in
  { holds = those True; fails = those False }

let rec sets w : Zone_question.t -> sets = function
  | Now p -> now w p
  | Operator o -> of_operator w o
  | Not q ->
    let { holds; fails } = sets w q in
    { holds = fails; fails = holds }
  | All all ->
    let both a b = { holds = Union.inter a.holds b.holds; fails = Union.union a.fails b.fails } in
    List.fold_left both { holds = Union.of_polyhedron (box w); fails = Union.empty (Array.length w.ranges) }
      (List.map (sets w) all)
  | Some_of all -> sets w (Not (All (List.map (fun q -> Zone_question.Not q) all)))

(* {1 Verdicts} *)

let unknown ranges =
  let none = Union.empty (Array.length ranges) in
  Where.make ranges ~holds:none ~fails:none

let by_start w starts : Verdict.t =
  let answer = Option.fold ~none:Answer.Infinite ~some:(fun x -> Answer.Exact x) in
  let value (s, chances) =
    let { Chances.low; high } = Chances.extremes chances in
    (s, { Scc_ctl.Eval.least = answer low; most = answer high })
  in
  let is_open (p : Chances.part) = not (Chances.is_known p.value) in
  let is_open (_, (c : Chances.t)) = List.exists is_open c.parts || not (Chances.known_everywhere c) in
  let some_open = List.exists is_open starts in
  let reasons = if some_open then snd (reasons w) else [] in
  Measured { values = List.map value starts; reasons; inexact = None; witness = None; curve = []; starts }

let of_sets w { holds; fails } =
  let where = Where.make w.ranges ~holds ~fails in
  let verdict : Verdict.t =
    if not (Union.is_empty where.fails) then Violated { witness = None }
    else if Union.is_empty where.unknown then Holds { bounds = []; witness = None }
    else Undecided (snd (reasons w))
  in
  (verdict, where)

let measured w sides (o : Zone_question.operator) =
  let graph = explore w o.until in
  let known (p, v) = (p, Chances.known w.ranges v) in
  let of_side s = Chances.make w.ranges (List.map known (pieces w graph o ~chance:true (side s))) in
  by_start w (Scc_explain.Likelihoods.of_sides ~is_chain:(fun () -> Chance_graph.is_chain graph) sides of_side)

(* {2 Means} *)

(* The ends of a mean on pieces that divide the box. Where all is known, one of them is enough. *)
let mean_ends w graph s =
  let parameters = Array.length w.ranges and most = most_layers w graph in
  let f unknown = Chance_mean.solve ~most ~progress:(valued w) graph { choice = side s; unknown } ~parameters in
  let pieces box f = Affine.pieces box f in
  let known = function
    | Some v -> v
    | None -> Bug.fail __POS__ "a start without a value"
  in
  let all_known = fst (reasons w) = [] && snd (reasons w) = [] in
  let least = f `Least in
  let with_most most (p, v) = List.map (fun (q, u) -> (q, known v, known u)) (pieces p most) in
  if all_known then List.map (fun (p, v) -> (p, known v, known v)) (pieces (box w) least)
  else List.concat_map (with_most (f `Greatest)) (pieces (box w) least)

(* The function by its pieces; [None] if nothing is known anywhere. *)
let by_pieces w pieces =
  let of_piece (p, (least : Affine.value), (most : Affine.value)) =
    match (least, most) with
    | Unknown, _ | _, Unknown -> Either.Right p
    | (Finite _ | Infinite), (Finite _ | Infinite) ->
      let form : Affine.value -> Linear.t option = function Finite f -> Some f | Infinite | Unknown -> None in
      Left (p, { Chances.least = form least; most = form most })
  in
  match List.partition_map of_piece pieces with
  | [], _ -> None
  | known, unknown -> Some (Chances.make w.ranges ~unknown known)

(* Where a mean stands so to a number. *)
let where_it_is w pieces (test : Answer.bound) =
  let constraint_ f =
    let than = Linear.constant (Linear.dimension f) test.than in
    match test.relation with
    | Less -> Constraint.less f than
    | At_most -> Constraint.at_most f than
    | At_least_so -> Constraint.at_least f than
    | More -> Constraint.greater f than
  in
  let split p : Affine.value -> Polyhedron.t list * Polyhedron.t list = function
    | Finite f ->
      let yes, no = Region.split p [ constraint_ f ] in
      (Option.to_list yes, no)
    | Infinite -> if Answer.holds Infinite test = Some true then ([ p ], []) else ([], [ p ])
    | Unknown -> ([], [])
  in
  let both (p, least, most) =
    let yes, no = split p least in
    (List.concat_map (fun q -> fst (split q most)) yes, List.concat_map (fun q -> snd (split q most)) no)
  in
  let parts = List.map both pieces in
  let all side = Union.of_polyhedra (Array.length w.ranges) (List.concat_map side parts) in
  { holds = all fst; fails = all snd }

let mean w sides mean (test : Answer.bound option) =
  let graph = explore w (Zone_question.of_mean mean) in
  match (test, sides) with
  | Some test, s :: _ -> of_sets w (where_it_is w (mean_ends w graph s) test)
  | _ ->
    let of_side s = by_pieces w (mean_ends w graph s) in
    let is_chain () = Chance_graph.is_chain graph in
    let sides = Scc_explain.Likelihoods.of_sides ~is_chain sides of_side in
    let known (s, found) = Option.map (fun c -> (s, c)) found in
    let verdict =
      match Option.all known sides with
      | Some starts -> by_start w starts
      | None -> Verdict.Undecided (snd (reasons w))
    in
    (verdict, unknown w.ranges)

let answer w (check : Property.check) =
  match check.asked with
  | Expected (sides, asked, test) -> mean w sides asked test
  | Whether -> of_sets w (sets w (Zone_question.of_formula check.formula))
  | How_likely sides -> (
      match Zone_question.of_formula check.formula with
      | Operator o -> (measured w sides o, unknown w.ranges)
      | Now _ | Not _ | All _ | Some_of _ -> Bug.fail __POS__ "a probability of no operator")

(* Values of what was explored may take longer than there is time for. Then those of its first layers are known,
   and of as many of them as are solved in time. *)
let shares = [ 1; 2; 3; 4; 6; 8 ]

let answer_in_time w (check : Property.check) =
  let around = w.options.Setup.surroundings in
  let with_share eighths () =
    w.eighths <- eighths;
    answer w check
  in
  List.iter (begin_with w) (Zone_question.untils_of check);
  if not (List.exists (fun g -> (Chance_graph.met g).stopped) w.used) then answer w check
  else
    let rec further best = function
      | [] -> best
      | share :: rest -> (
          match around.attempt.run Exploring (with_share share) with
          | Ok found -> further (Some found) rest
          | Error _ -> best)
    in
    match further None shares with
    | Some found -> found
    | None -> (
        (* Nothing but the time of conclusions is left. *)
        match (around.share ~mine:2 ~all:3).attempt.run Concluding (with_share 8) with
        | Ok found -> found
        | Error _ -> with_share (List.hd shares) ())

type result = { verdict : Verdict.t; where : Where.t; stats : Stats.t }

let check (options : Setup.t) shared semantics context u ~declared (check : Property.check) =
  let m = Semantics.model semantics in
  let initial = Network.started semantics declared in
  let starts ~keeps_time = Start.zones context u ~initial ~keeps_time in
  let w = Chance_work.make options context shared ~starts in
  let without reason faults =
    let stopped_by = match reason with Verdict.Truncated t -> [ t ] | _ -> [] in
    let stats = { (stats w ~faults) with complete = false; stopped_by } in
    Ok { verdict = Undecided [ reason ]; where = unknown m.ranges; stats }
  in
  let faulty fault at =
    let d = Transition.diagnostic ~at m fault in
    without (Verdict.Fault d.message) [ d ]
  in
  match sure w Concluding (fun () -> answer_in_time w check) with
  | verdict, where -> Ok { verdict; where; stats = stats w ~faults:[] }
  | exception Limits.Over stop -> without (Truncated (Bounds.stopped options.bounds stop)) []
  | exception Ill_formed fault -> Error fault
  | exception Zone_question.Not_asked reason -> without (Undefined reason) []
  | exception Instant.Not_affine reason -> without (Fault reason) []
  | exception Law_cells.Bad_law { leaf; fault; at } -> faulty (Bad_law { leaf; fault }) at
  | exception Chance_steps.Bad { fault; at } -> faulty fault at
