open Scc_data
open Scc_exact

type undefined = { predicate : int; position : Positions.position; reason : string }
type t = { unexplored : int list; undefined : undefined list }

type search = {
  eval : Eval.t;
  graph : Timed_graph.t;
  unexplored_nodes : Bits.t;
  mutable found : undefined list;
}

(* Positions to begin at. Which of the offsets of a flow are meant is not kept: all at which there is doubt. *)
type sources = { nodes : int list; flows : int list }

let doubtful (v : Eval.value) =
  if v.lower == v.upper then ((fun _ -> false), fun _ -> false)
  else
    ( (fun s -> not (Bool.equal (Positions.at v.lower s) (Positions.at v.upper s))),
      fun s -> not (Pieces.equal (Positions.along v.lower s) (Positions.along v.upper s)) )

let restrict (v : Eval.value) sources =
  let node, flow = doubtful v in
  { nodes = List.filter node sources.nodes; flows = List.filter flow sources.flows }

let has_flow t s =
  match Timed_graph.flow t.graph s with No_flow -> false | Lasts _ | Forever -> true

(** {2 Predicates} *)

let record t predicate position reason =
  let same u = Int.equal u.predicate predicate && String.equal u.reason reason in
  if not (List.exists same t.found) then t.found <- { predicate; position; reason } :: t.found

(* The first instant of a flow at which the predicate is undecided. *)
let along_flow t p s =
  let predicates = Eval.predicates t.eval in
  let is_undecided : Truth.t -> bool = function Undecided _ -> true | True | False -> false in
  let timeline = predicates.along p s (Timed_graph.extent (Timed_graph.flow t.graph s)) in
  match Timeline.first_after_start is_undecided timeline with
  | None -> ()
  | Some moment -> (
      let offset = Timeline.sample timeline moment in
      match Timeline.at timeline offset with
      | Undecided reason -> record t p { node = s; offset } reason
      | True | False -> ())

let predicate t p sources =
  let predicates = Eval.predicates t.eval in
  let node s =
    match predicates.at p s with
    | Undecided reason -> record t p (Positions.start s) reason
    | True | False -> ()
  in
  List.iter node sources.nodes;
  List.iter (if predicates.steady p then node else along_flow t p) sources.flows

(** {2 Formulas} *)

let positions t sources =
  let last s : Positions.position =
    match Timed_graph.flow t.graph s with
    | Lasts (d, _) -> { node = s; offset = Algebraic.of_rat d }
    | No_flow | Forever -> { node = s; offset = Algebraic.of_rat Rat.one }
  in
  List.rev_append (List.rev_map Positions.start sources.nodes) (List.rev_map last sources.flows)

let unexplored t s = Bits.add t.unexplored_nodes s

(* Through flows only, to edges; the positions at which they lead to doubt. *)
let next t (f : Eval.value) sources =
  let doubt, _ = doubtful f in
  let found = ref [] in
  let look u = if doubt u then found := u :: !found in
  let seen = Bits.create t.graph.size in
  let rec go = function
    | [] -> ()
    | s :: rest when Bits.mem seen s -> go rest
    | s :: rest ->
      Bits.add seen s;
      if not (t.graph.known s) then unexplored t s;
      Array.iter look (Timed_graph.edges t.graph s);
      go (Array.fold_left (fun acc u -> u :: acc) rest (Timed_graph.targets (Timed_graph.flow t.graph s)))
  in
  let ends s = Array.to_list (Timed_graph.targets (Timed_graph.flow t.graph s)) in
  go (List.rev_append (List.concat_map ends sources.flows) sources.nodes);
  { nodes = List.sort_uniq Int.compare !found; flows = [] }

(* What is visited on the way of an operator: as long as f may hold and, unless the bound begins later, g need
   not. The nodes at which that ends are among them when there is a bound; there is nothing to doubt at them
   else. *)
type way = { visited : int list; through : int list }

let way t (u : Eval.until) (f : Eval.value) (g : Eval.value) in_doubt sources =
  let late = Rat.sign u.bound.low > 0 in
  let unbounded = Option.is_some in_doubt && (not late) && Option.is_none u.bound.high in
  let in_doubt = Option.value in_doubt ~default:(fun _ -> true) in
  let through s =
    if unbounded then in_doubt s else Positions.at f.upper s && (late || not (Positions.at g.lower s))
  in
  let passes (p : Positions.position) =
    Positions.is_inside p
    ||
    let f = Positions.along f.upper p.node in
    let g = if late then Pieces.constant false else Positions.along g.lower p.node in
    match Flow.entering ~f ~g with Passes -> true | Reached _ | Lost _ -> false
  in
  let visited = ref [] in
  let keep s = if (not unbounded) || in_doubt s then visited := s :: !visited in
  Reachable.visit t.graph ?within:u.bound.high (positions t sources) ~through ~passes keep;
  let visited = List.rev !visited in
  { visited; through = List.filter through visited }

(* A probability may be in doubt for what comes after positions from which on it is known well enough. *)
let is_likelihood eval formula =
  match Eval.as_until eval formula with Some ({ quantifier = Chance _; _ }, _) -> true | Some _ | None -> false

let rec has_likelihood eval (f : Timed_formula.t) =
  match f with
  | Not f -> has_likelihood eval f
  | And fs | Or fs -> List.exists (has_likelihood eval) fs
  | Predicate _ | Next _ | Until _ | Finally _ | Globally _ -> is_likelihood eval f

let rec walk t (formula : Timed_formula.t) sources =
  let sources = if has_likelihood t.eval formula then sources else restrict (Eval.value t.eval formula) sources in
  match (sources, formula) with
  | { nodes = []; flows = [] }, _ -> ()
  | _, Predicate p -> predicate t p sources
  | _, Not f -> walk t f sources
  | _, (And fs | Or fs) -> List.iter (fun f -> walk t f sources) fs
  | _, Next (_, f) -> walk t f (next t (Eval.value t.eval f) sources)
  | _, (Until _ | Finally _ | Globally _) -> (
      match Eval.as_until t.eval formula with
      | None -> Scc_base.Bug.fail __POS__ "an operator of time that is none"
      | Some (u, _) -> until t u formula sources)

and until t (u : Eval.until) formula sources =
  let f = Eval.value t.eval u.left and g = Eval.value t.eval u.right in
  let in_doubt =
    if is_likelihood t.eval formula then None else Some (fst (doubtful (Eval.value t.eval formula)))
  in
  let { visited; through } = way t u f g in_doubt sources in
  let known, unknown = List.partition t.graph.known through in
  List.iter (unexplored t) unknown;
  let flows = List.filter (has_flow t) (List.rev_append sources.flows known) in
  walk t u.left { nodes = visited; flows };
  walk t u.right { nodes = visited; flows }

let possible eval formula (position : Positions.position) =
  let graph = Eval.graph eval in
  let t = { eval; graph; unexplored_nodes = Bits.create graph.size; found = [] } in
  let sources =
    if Positions.is_inside position then { nodes = []; flows = [ position.node ] }
    else { nodes = [ position.node ]; flows = [] }
  in
  walk t formula sources;
  let nodes = ref [] in
  for s = graph.size - 1 downto 0 do
    if Bits.mem t.unexplored_nodes s then nodes := s :: !nodes
  done;
  { unexplored = !nodes; undefined = List.rev t.found }

let find eval formula position =
  match Eval.truth eval formula position with
  | Some _ -> { unexplored = []; undefined = [] }
  | None -> possible eval formula position
