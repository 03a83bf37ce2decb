open Scc_exact
open Scc_graph_search
open Scc_calculus
open Scc_state_sets
open Scc_semantics
open Scc_property
open Scc_symbolic
open Scc_verify

(* An exploration is that of all checks of a model that ask about the same until. It is kept for those to come. *)
type shared = {
  mutable to_come : Chance_claims.question list;
  mutable known : (Chance_claims.question * Chance_graph.t) list;
}

let shared checks =
  { to_come = List.concat_map Zone_question.untils_of checks; known = [] }

let groups checks =
  let common (_, us) (_, vs) = List.exists (fun u -> List.exists (Chance_claims.same_question u) vs) us in
  let add found x =
    let near, others = List.partition (List.exists (common x)) found in
    (x :: List.concat near) :: others
  in
  let by_number (i, _) (j, _) = Int.compare i j in
  List.mapi (fun i c -> ((i, c), Zone_question.untils_of c)) checks
  |> List.fold_left add []
  |> List.map (fun group -> List.sort by_number (List.map fst group))
  |> List.sort (fun a b -> by_number (List.hd a) (List.hd b))

let without_first is list =
  let add (found, kept) x = if (not found) && is x then (true, kept) else (found, x :: kept) in
  List.rev (snd (List.fold_left add (false, []) list))

(* The work on a check, and what is kept of its explorations. *)
type t = {
  options : Setup.t;
  context : Instant.context;
  ranges : Ranges.t;
  starts : keeps_time:bool -> (Zone.t list, Start.fault) Stdlib.result;
  shared : shared;
  mutable used : Chance_graph.t list;
  mutable explored : Chance_graph.t list;  (** those of [used] that no check has explored before *)
  mutable stop : Scc_graph_search.Limits.stop option;
  mutable graphs : (Chance_claims.question * Chance_graph.t) list;  (** what was explored or taken over *)
  mutable eighths : int;  (** how many eighths of the layers have values if the exploration was stopped *)
}

let make (options : Setup.t) (context : Instant.context) shared ~starts =
  let ranges = (Semantics.model context.semantics).ranges in
  {
    options; context; ranges; starts; shared; used = []; explored = []; stop = None; graphs = []; eighths = 8;
  }

exception Ill_formed of Start.fault

(* What is given up here has no part that could be reported. *)
let sure w stage f =
  match w.options.Setup.surroundings.attempt.run stage f with
  | Ok x -> x
  | Error stop -> raise (Limits.Over stop)

let zones w ~keeps_time =
  match sure w Exploring (fun () -> w.starts ~keeps_time) with
  | Ok zones -> zones
  | Error fault -> raise (Ill_formed fault)

let default_zones = 50_000

(* Values take a part of the time that the zones take: a quarter of the seconds is left for them. *)
let stop_of (around : Limits.surroundings) =
  let half = around.half () in
  let quarter = lazy (around.half ()) in
  fun () ->
    match around.stop () with
    | Some _ as stop -> stop
    | None -> if Option.is_none (half.stop ()) then None else (Lazy.force quarter).stop ()

let limits w : Chance_graph.limits =
  let { Setup.bounds; surroundings; _ } = w.options in
  let depth = match (Zone_bounds.depth bounds).limit with Depth d -> d | _ -> Zone_bounds.default_depth in
  let progress ~zones ~waiting ~depth zone =
    let model_time = lazy (Zone.earliest zone) in
    surroundings.progress (Explored { states = zones; transitions = 0; waiting; depth; model_time })
  in
  let is_over = stop_of surroundings in
  let stop () =
    if Option.is_none w.stop then w.stop <- is_over ();
    Option.is_some w.stop
  in
  let attempt f =
    match surroundings.attempt.run Exploring f with
    | Ok x -> Some x
    | Error stop ->
      w.stop <- Some stop;
      None
  in
  let zones = Option.value (Bounds.value bounds.states) ~default:default_zones in
  { horizon = Bounds.value bounds.time; depth; zones; stop; attempt; progress }

let explored_anew w (until : Chance_claims.question) =
  let m = Semantics.model w.context.semantics in
  let timed = Rat.sign until.bound.low > 0 || Option.is_some until.bound.high in
  let bounded = Option.is_some (Bounds.value w.options.bounds.time) in
  let named = List.map (fun p -> Property.State p) (Chance_claims.predicates until) in
  let keeps_time = timed || bounded || m.keeps_time || List.exists Formula.mentions_time named in
  let graph = Chance_graph.explore w.context until (limits w) (zones w ~keeps_time) in
  w.explored <- graph :: w.explored;
  graph

(* What was given up for its time is explored anew, in the time of another check. *)
let explore_or_take w until =
  let s = w.shared and is_it = Chance_claims.same_question until in
  let graph =
    match List.find_opt (fun (q, _) -> is_it q) s.known with
    | Some (_, graph) -> graph
    | None -> explored_anew w until
  in
  s.to_come <- without_first is_it s.to_come;
  let others = List.filter (fun (q, _) -> not (is_it q)) s.known in
  let is_kept = List.exists is_it s.to_come && not (Chance_graph.met graph).stopped in
  s.known <- (if is_kept then (until, graph) :: others else others);
  w.used <- graph :: w.used;
  w.graphs <- (until, graph) :: w.graphs

(* Once for each until of a check. *)
let begin_with w until =
  if List.exists (fun (q, _) -> Chance_claims.same_question until q) w.graphs then
    w.shared.to_come <- without_first (Chance_claims.same_question until) w.shared.to_come
  else explore_or_take w until

let explore w until = snd (List.find (fun (q, _) -> Chance_claims.same_question until q) w.graphs)

let most_layers w graph =
  let all = Chance_graph.count_layers graph in
  if (Chance_graph.met graph).stopped then ((w.eighths * all) + 7) / 8 else all

let valued w ~sets ~all = w.options.Setup.surroundings.progress (Valued { sets; all })

let box w = Ranges.box w.ranges

(* {1 Reasons and statistics} *)

(* Why something is open: bounds that were met, and predicates. *)
let reasons w =
  let { Setup.bounds; _ } = w.options in
  let of_graph graph =
    let met = Chance_graph.met graph in
    let default : Verdict.truncation = { limit = States default_zones; origin = By_default } in
    let states = if Option.is_some (Bounds.value bounds.states) then Zone_bounds.states bounds else default in
    let late = Option.map (fun t -> { Verdict.limit = Time t; origin = By_user }) (Bounds.value bounds.time) in
    let stopped = Option.map (Bounds.stopped bounds) w.stop in
    let when_ is bound = if is then Option.to_list bound else [] in
    List.concat
      [
        when_ met.too_late late; when_ met.too_deep (Some (Zone_bounds.depth bounds));
        when_ met.too_many (Some states); when_ met.stopped stopped;
      ]
  in
  let bounds = Verdict.distinct (List.concat_map of_graph w.used) in
  let texts = List.sort_uniq String.compare (List.concat_map Chance_graph.reasons w.used) in
  (bounds, List.map (fun t -> Verdict.Truncated t) bounds @ List.map (fun r -> Verdict.Undefined r) texts)

let stats w ~faults : Stats.t =
  let sum f = List.fold_left (fun n g -> n + f g) 0 w.explored in
  let stopped_by, reasons = reasons w in
  {
    Stats.none with
    decided_early = false;
    states = sum Chance_graph.size;
    transitions = sum Chance_graph.transitions;
    depth = List.fold_left (fun d g -> Int.max d (Chance_graph.depth g)) 0 w.explored;
    complete = reasons = [] && faults = [];
    split_step = (match (Semantics.model w.context.semantics).splits with Every s -> Some s | Any_time -> None);
    stopped_by;
    faults;
  }
