open Scc_exact
open Scc_polyhedra
open Scc_property

(* [Reaches]: some run leads to a state that the search looks for; [Avoids]: none does. *)
type plan =
  | Reaches of Search_sets.t
  | Avoids of Search_sets.t
  | Starts of Search_sets.t  (** looked for in the initial states alone *)
  | All of plan list
  | Any of plan list
  | Beyond of string

type t = { context : Instant.context; parameters : Polyhedron.t; plan : plan; bound : Rat.t option }

let beyond =
  "over all starts and instants only `possibly` and `always` of what is there at an instant are followed, with \
   `not`, `and` and `or` of them"

let make context atoms ~parameters formula =
  let n = Polyhedron.dimension parameters in
  let search bound prop = Search_sets.make atoms ~parameters:n ~bound prop in
  let rec plan : Plan.t -> plan = function
    | Now p -> Starts (search None p)
    | Possibly (bound, p) -> Reaches (search bound p)
    | Always (bound, p) -> Avoids (search bound (Formula.negate p))
    | All plans -> All (List.map plan plans)
    | Any plans -> Any (List.map plan plans)
    | Formula _ -> Beyond beyond
  in
  { context; parameters; plan = plan (Plan.of_formula formula); bound = Plan.horizon formula }

let bound t = t.bound

let rec bounded : Plan.t -> bool = function
  | Now _ | Formula _ -> false
  | Possibly (bound, _) | Always (bound, _) -> Option.is_some bound
  | All plans | Any plans -> List.exists bounded plans

let needs_time formula = Formula.mentions_time formula || bounded (Plan.of_formula formula)

(* {1 Looking} *)

let rec each f = function
  | (Reaches _ | Avoids _ | Starts _) as plan -> f plan
  | All plans | Any plans -> List.iter (each f) plans
  | Beyond _ -> ()

let is_root (node : Zone_graph.node) = node.depth = 0

let look t node =
  each
    (function
      | Reaches s | Avoids s -> Search_sets.look t.context s node
      | Starts s -> if is_root node then Search_sets.look_at s node
      | All _ | Any _ | Beyond _ -> ())
    t.plan

let look_around t node =
  each
    (function
      | Reaches s | Avoids s -> Search_sets.look_around s node
      | Starts s -> if is_root node then Search_sets.look_around s node
      | All _ | Any _ | Beyond _ -> ())
    t.plan

let leave t zone =
  each
    (function Reaches s | Avoids s -> Search_sets.leave s zone | Starts _ | All _ | Any _ | Beyond _ -> ())
    t.plan

(* {1 Sets} *)

type sets = { holds : Union.t; fails : Union.t }

let rec sets_of all = function
  | Reaches s | Starts s -> found all s
  | Avoids s ->
    let { holds; fails } = found all s in
    { holds = fails; fails = holds }
  | All plans -> List.fold_left (both all) { holds = all; fails = Union.empty (Union.dimension all) } plans
  | Any plans -> List.fold_left (either all) { holds = Union.empty (Union.dimension all); fails = all } plans
  | Beyond _ -> { holds = Union.empty (Union.dimension all); fails = Union.empty (Union.dimension all) }

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

(* Whether it is decided for all values, whatever is still to be found. *)
let rec decided t ~exactly = function
  | Reaches s -> Search_sets.covers s t.parameters
  | Avoids s ->
    if exactly then Search_sets.covers s t.parameters else not (Union.is_empty (Search_sets.found s))
  | Starts _ | Beyond _ -> false
  | All plans | Any plans -> List.for_all (decided t ~exactly) plans

let is_known t ~exactly = decided t ~exactly t.plan

let rec safe = function
  | Avoids s -> Union.is_empty (Search_sets.found s) && Search_sets.reasons s = []
  | Starts _ | Reaches _ | Beyond _ -> false
  | All plans -> List.for_all safe plans
  | Any plans -> List.exists safe plans

let safe_so_far t = safe t.plan

let rec reasons_of = function
  | Reaches s | Avoids s | Starts s -> Search_sets.reasons s
  | All plans | Any plans -> List.concat_map reasons_of plans
  | Beyond reason -> [ reason ]

let reasons t = List.sort_uniq String.compare (reasons_of t.plan)

let rec place ~holds = function
  | Reaches s | Starts s -> if holds then Search_sets.first s else None
  | Avoids s -> if holds then None else Search_sets.first s
  | All plans -> if holds then None else List.find_map (place ~holds) plans
  | Any plans -> if holds then List.find_map (place ~holds) plans else None
  | Beyond _ -> None

let shown_by t ~holds = place ~holds t.plan
