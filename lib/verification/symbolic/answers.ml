open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets

(* [Reaches]: some run leads to a state that the search looks for; [Avoids]: none does. *)
type plan =
  | Reaches of Search_sets.t
  | Avoids of Search_sets.t
  | Starts of Search_sets.t  (** looked for in the initial states alone *)
  | All of plan list
  | Any of plan list
  | Branches of branches  (** asked of the graph when all is known *)

(* [everywhere]: it holds for all values; [settled]: nothing of it is open. *)
and branches = { formula : Property.temporal; mutable answer : (concluded, string) result option }

and concluded = { found : Branching.answer; everywhere : bool; settled : bool }

type t = {
  context : Instant.context;
  atoms : Atoms.context;
  parameters : Polyhedron.t;
  plan : plan;
  formula : Property.temporal;
}

let make context atoms ~parameters formula =
  let n = Polyhedron.dimension parameters in
  let search bound prop = Search_sets.make atoms ~parameters:n ~bound prop in
  let rec plan : Plan.t -> plan = function
    | Now p -> Starts (search None p)
    | Possibly (bound, p) -> Reaches (search bound p)
    | Always (bound, p) -> Avoids (search bound (Formula.negate p))
    | All plans -> All (List.map plan plans)
    | Any plans -> Any (List.map plan plans)
    | Formula formula -> Branches { formula; answer = None }
  in
  { context; atoms; parameters; plan = plan (Plan.of_formula formula); formula }

let reach t = Plan.reach t.formula

let rec bounded (f : Property.temporal) =
  (match f with
   | Finally (_, b, _) | Globally (_, b, _) | Until (_, b, _, _) -> Rat.sign b.low > 0 || Option.is_some b.high
   | State _ | Temporal_not _ | Temporal_and _ | Temporal_or _ | Next _ -> false)
  || List.exists bounded (Parts.of_temporal f)

let needs_time formula = Formula.mentions_time formula || bounded formula

(* {1 Looking} *)

let rec each f = function
  | (Reaches _ | Avoids _ | Starts _) as plan -> f plan
  | All plans | Any plans -> List.iter (each f) plans
  | Branches _ -> ()

let is_root (node : Zone_graph.node) = node.depth = 0

let look t node =
  each
    (function
      | Reaches s | Avoids s -> Search_sets.look t.context s node
      | Starts s -> if is_root node then Search_sets.look_at s node
      | All _ | Any _ | Branches _ -> ())
    t.plan

let look_around t node =
  each
    (function
      | Reaches s | Avoids s -> Search_sets.look_around s node
      | Starts s -> if is_root node then Search_sets.look_around s node
      | All _ | Any _ | Branches _ -> ())
    t.plan

let leave t zone =
  each
    (function Reaches s | Avoids s -> Search_sets.leave s zone | Starts _ | All _ | Any _ | Branches _ -> ())
    t.plan

let rec conclude_plan t graph = function
  | Branches b ->
    let concluded (found : Branching.answer) =
      let settled = Union.covers (Union.union found.holds found.fails) t.parameters in
      { found; everywhere = Union.covers found.holds t.parameters; settled }
    in
    b.answer <- Some (Result.map concluded (Branching.answer t.context t.atoms graph b.formula))
  | All plans | Any plans -> List.iter (conclude_plan t graph) plans
  | Reaches _ | Avoids _ | Starts _ -> ()

let conclude t graph = conclude_plan t graph t.plan
let is_search t = Plan.is_search (Plan.of_formula t.formula)

(* {1 Sets} *)

type sets = { holds : Union.t; fails : Union.t }

let rec sets_of all = function
  | Reaches s | Starts s -> found all s
  | Avoids s ->
    let { holds; fails } = found all s in
    { holds = fails; fails = holds }
  | All plans -> List.fold_left (both all) { holds = all; fails = Union.empty (Union.dimension all) } plans
  | Any plans -> List.fold_left (either all) { holds = Union.empty (Union.dimension all); fails = all } plans
  | Branches { answer = None | Some (Error _); _ } ->
    let none = Union.empty (Union.dimension all) in
    { holds = none; fails = none }
  | Branches { answer = Some (Ok { found; _ }); _ } ->
    { holds = Union.inter found.holds all; fails = Union.inter found.fails all }

and found all s =
  let holds = Union.inter (Search_sets.found s) all in
  { holds; fails = Union.difference (Union.difference all holds) (Search_sets.open_ s) }

and both all sets plan =
  let more = sets_of all plan in
  { holds = Union.inter sets.holds more.holds; fails = Union.union sets.fails more.fails }

and either all sets plan =
  let more = sets_of all plan in
  { holds = Union.union sets.holds more.holds; fails = Union.inter sets.fails more.fails }

let sets t = sets_of (Union.of_polyhedron t.parameters) t.plan

(* {1 How it stands} *)

(* Whatever is still to be found: whether it is known for each value whether it holds; *)
let rec known t = function
  | Reaches s | Avoids s -> Search_sets.covers s t.parameters
  | Branches { answer = Some (Ok concluded); _ } -> concluded.settled
  | Starts _ | Branches { answer = None | Some (Error _); _ } -> false
  | All plans | Any plans -> List.for_all (known t) plans

(* that it fails for some value: what fails for one each, of several that need not all hold, may fail for none; *)
let rec fails_somewhere = function
  | Avoids s -> not (Union.is_empty (Search_sets.found s))
  | All plans -> List.exists fails_somewhere plans
  | Branches { answer = Some (Ok concluded); _ } -> not (Union.is_empty concluded.found.fails)
  | Reaches _ | Starts _ | Branches { answer = None | Some (Error _); _ } | Any _ -> false

(* that it holds for all values. *)
let rec holds_everywhere t = function
  | Reaches s -> Search_sets.covers s t.parameters
  | All plans -> List.for_all (holds_everywhere t) plans
  | Any plans -> List.exists (holds_everywhere t) plans
  | Branches { answer = Some (Ok concluded); _ } -> concluded.everywhere
  | Avoids _ | Starts _ | Branches { answer = None | Some (Error _); _ } -> false

let is_known t ~exactly =
  known t t.plan || ((not exactly) && (fails_somewhere t.plan || holds_everywhere t t.plan))

let rec safe = function
  | Avoids s -> Union.is_empty (Search_sets.found s) && Search_sets.reasons s = []
  | Starts _ | Reaches _ | Branches _ -> false
  | All plans -> List.for_all safe plans
  | Any plans -> List.exists safe plans

let safe_so_far t = safe t.plan

let rec reasons_of = function
  | Reaches s | Avoids s | Starts s -> Search_sets.reasons s
  | All plans | Any plans -> List.concat_map reasons_of plans
  | Branches { answer = Some (Error reason); _ } -> [ reason ]
  | Branches { answer = None | Some (Ok _); _ } -> []

let reasons t = List.sort_uniq String.compare (reasons_of t.plan)

let rec place ~holds = function
  | Reaches s | Starts s -> if holds then Search_sets.first s else None
  | Avoids s -> if holds then None else Search_sets.first s
  | All plans -> if holds then None else List.find_map (place ~holds) plans
  | Any plans -> if holds then List.find_map (place ~holds) plans else None
  | Branches _ -> None

let shown_by t ~holds = place ~holds t.plan

let rec branch all ~holds = function
  | Branches { answer = Some (Ok { found; _ }); formula } ->
    let so = Union.inter (if holds then found.holds else found.fails) all in
    if Union.is_empty so then None else Some (found.decided, formula)
  | Branches { answer = None | Some (Error _); _ } | Reaches _ | Avoids _ | Starts _ -> None
  | All plans -> if holds then None else List.find_map (branch all ~holds) plans
  | Any plans -> if holds then List.find_map (branch all ~holds) plans else None

let run t graph ~holds =
  Option.bind (branch (Union.of_polyhedron t.parameters) ~holds t.plan) (fun (b, f) ->
      Shown_run.make graph b f ~holds)
