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

and branches = { formula : Property.temporal; mutable answer : (Branching.t * Union.t, string list) result }

type t = {
  context : Instant.context;
  atoms : Atoms.context;
  parameters : Polyhedron.t;
  plan : plan;
  reach : Plan.reach option;
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
    | Formula formula -> Branches { formula; answer = Error [] }
  in
  { context; atoms; parameters; plan = plan (Plan.of_formula formula); reach = Plan.reach formula }

let reach t = t.reach

let rec bounded : Property.temporal -> bool = function
  | State _ -> false
  | Temporal_not f | Next (_, f) -> bounded f
  | Temporal_and fs | Temporal_or fs -> List.exists bounded fs
  | Finally (_, b, f) | Globally (_, b, f) -> some_bound b || bounded f
  | Until (_, b, f, g) -> some_bound b || bounded f || bounded g

and some_bound b = Rat.sign b.low > 0 || Option.is_some b.high

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
    b.answer <- Result.map_error (fun reason -> [ reason ]) (Branching.holds t.context t.atoms graph b.formula)
  | All plans | Any plans -> List.iter (conclude_plan t graph) plans
  | Reaches _ | Avoids _ | Starts _ -> ()

let conclude t graph = conclude_plan t graph t.plan

(* {1 Sets} *)

type sets = { holds : Union.t; fails : Union.t }

let rec sets_of all = function
  | Reaches s | Starts s -> found all s
  | Avoids s ->
    let { holds; fails } = found all s in
    { holds = fails; fails = holds }
  | All plans -> List.fold_left (both all) { holds = all; fails = Union.empty (Union.dimension all) } plans
  | Any plans -> List.fold_left (either all) { holds = Union.empty (Union.dimension all); fails = all } plans
  | Branches { answer = Error _; _ } ->
    let none = Union.empty (Union.dimension all) in
    { holds = none; fails = none }
  | Branches { answer = Ok (_, holds); _ } ->
    let holds = Union.inter holds all in
    { holds; fails = Union.difference all holds }

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
  | Starts _ | Branches _ -> false
  | All plans | Any plans -> List.for_all (known t) plans

(* that it fails for some value: what fails for one each, of several that need not all hold, may fail for none; *)
let rec fails_somewhere = function
  | Avoids s -> not (Union.is_empty (Search_sets.found s))
  | All plans -> List.exists fails_somewhere plans
  | Reaches _ | Starts _ | Branches _ | Any _ -> false

(* that it holds for all values. *)
let rec holds_everywhere t = function
  | Reaches s -> Search_sets.covers s t.parameters
  | All plans -> List.for_all (holds_everywhere t) plans
  | Any plans -> List.exists (holds_everywhere t) plans
  | Avoids _ | Starts _ | Branches _ -> false

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
  | Branches { answer = Error reasons; _ } -> reasons
  | Branches { answer = Ok _; _ } -> []

let reasons t = List.sort_uniq String.compare (reasons_of t.plan)

let rec place ~holds = function
  | Reaches s | Starts s -> if holds then Search_sets.first s else None
  | Avoids s -> if holds then None else Search_sets.first s
  | All plans -> if holds then None else List.find_map (place ~holds) plans
  | Any plans -> if holds then List.find_map (place ~holds) plans else None
  | Branches _ -> None

let shown_by t ~holds = place ~holds t.plan

let rec branch all ~holds = function
  | Branches { answer = Ok (b, set); formula } ->
    let so = if holds then Union.inter set all else Union.difference all set in
    if Union.is_empty so then None else Some (b, formula)
  | Branches { answer = Error _; _ } | Reaches _ | Avoids _ | Starts _ -> None
  | All plans -> if holds then None else List.find_map (branch all ~holds) plans
  | Any plans -> if holds then List.find_map (branch all ~holds) plans else None

let run t graph ~holds =
  Option.bind (branch (Union.of_polyhedron t.parameters) ~holds t.plan) (fun (b, f) ->
      Shown_run.make graph b f ~holds)
