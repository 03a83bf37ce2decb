open Scc_ctl
open Scc_exact
open Scc_property
module Graph = State_graph

type asked = Formulas.asked

type t = { context : Network_lts.context; asked : asked; graph : Graph.t; formulas : Formulas.t }

let ask = Formulas.ask

let is_timed g (e : Graph.edge) = Rat.sign (Graph.duration g e) > 0

(* The edges of some kind, with their indices among all. *)
let indexed test edges =
  let all = Array.to_list (Array.mapi (fun k e -> (k, e)) edges) in
  Array.of_list (List.filter (fun (_, e) -> test e) all)

let drawn context g =
  let chance (e : Graph.edge) = Catalogue.chance (Network_lts.catalogue context) e.label in
  if not (Scc_calculus.Model.decides_by_chance (Network_lts.model context)) then fun _ -> None
  else
    fun i ->
      let chances = Array.map chance (Graph.edges g i) in
      if Array.exists Option.is_some chances then Some chances else None

let timed_graph context ~rests g : Timed_graph.t =
  let size = Graph.size g in
  let known i =
    match Graph.status g i with
    | Scc_graph_search.Explore.Expanded -> true
    | Queued | Unexpanded _ -> false
  in
  (* Whether a state without transitions rests is asked often, and is not quickly answered. *)
  let resting = Bytes.make size '?' in
  let rests i =
    if Char.equal (Bytes.get resting i) '?' then
      Bytes.set resting i (if rests (Graph.tuple g i) then 'y' else 'n');
    Char.equal (Bytes.get resting i) 'y'
  in
  let edges = Graph.targets g ~timed:false in
  (* All time transitions of a state have the same duration: that of its trajectory. *)
  let flow i : Timed_graph.flow =
    match Graph.passing g i with
    | Some d -> Lasts (d, Graph.targets g ~timed:true i)
    | None -> if Array.length (edges i) = 0 && rests i then Forever else No_flow
  in
  { size; known; edges; drawn = drawn context g; flow }

let predicates_on asked graph =
  let predicates = Formulas.predicates asked in
  (* Formulas are evaluated one after the other, each in all states, and may be as many as bodies. *)
  let room = Array.copy (Network_lts.initial (Graph.context graph)) in
  let read node =
    Graph.read_tuple graph node room;
    room
  in
  let along p node extent =
    match predicates.(p).On_the_fly.along with
    | Some along -> along (read node) extent
    | None -> Timeline.constant extent (predicates.(p).at (read node))
  in
  {
    Scc_ctl.Eval.at = (fun p node -> predicates.(p).at (read node));
    along;
    steady = (fun p -> Option.is_none predicates.(p).along);
  }

(* At an offset of the flow of a node. *)
let number graph (timed : Timed_graph.t) n node offset =
  let extent = Timed_graph.extent (Timed_graph.flow timed node) in
  Formulas.number_at (Graph.context graph) (Graph.tuple graph node) extent n offset

(* The transitions of a state but for the passing of time, in the order of the graph. *)
let counted graph p node k =
  let _, (e : Graph.edge) = (indexed (fun e -> not (is_timed graph e)) (Graph.edges graph node)).(k) in
  Formulas.counted_by (Graph.context graph) (Graph.tuple graph node) e.label p

let on ?surroundings ?seconds asked ~rests graph =
  let context = Graph.context graph in
  let timed = timed_graph context ~rests graph in
  let on : Formulas.on =
    {
      graph = timed;
      predicates = predicates_on asked graph;
      number = number graph timed;
      counted = counted graph;
    }
  in
  { context; asked; graph; formulas = Formulas.on ?surroundings ?seconds asked on }

let formulas t = t.formulas
let eval t = Formulas.eval t.formulas
let explain t i = Explanation.explain (eval t) (Formulas.formula t.formulas i) (Scc_ctl.Positions.start 0)
let contrast t explanation = Scc_ctl.Contrast.explain (eval t) explanation
let predicate t = Formulas.prop t.asked

type sensitivity = {
  temporal : t;
  parameter : Sensitivity.parameter;
  mutable known : ((Property.side * Timed_formula.t) * Scc_chance.Parametric.piece list Sensitivity.result) list;
  (** the functions of probabilities found so far: several checks may be about one *)
}

let sensitivity t range =
  let parameter = Edge_functions.make t.context range ~tuple:(Graph.tuple t.graph) (Eval.graph (eval t)) in
  { temporal = t; parameter; known = [] }

(* Whatever the test of a probability is, its function is the same. *)
let untested : Timed_formula.t -> Timed_formula.t = function
  | Finally (_, b, f) -> Finally (All, b, f)
  | Globally (_, b, f) -> Globally (All, b, f)
  | Until (_, b, f, g) -> Until (All, b, f, g)
  | f -> f

let probability_of s side formula =
  let formula = untested formula in
  let same ((other, f), _) = other = side && Timed_formula.compare f formula = 0 in
  match List.find_opt same s.known with
  | Some (_, found) -> found
  | None ->
    let found = Sensitivity.probability (eval s.temporal) s.parameter side formula in
    s.known <- ((side, formula), found) :: s.known;
    found

let probability_function s i side = probability_of s side (Formulas.formula s.temporal.formulas i)

let mean_function { temporal = t; parameter; _ } i side mean =
  Sensitivity.mean (eval t) parameter side (Formulas.what t.formulas i mean)

let where ({ temporal = t; parameter; _ } as s) i =
  Sensitivity.where (eval t) parameter ~probability:(probability_of s) (Formulas.formula t.formulas i)

let choice t (s : Scc_ctl.Run.step) : Graph.step =
  let edges = Graph.edges t.graph s.source in
  let nth test k = fst (indexed test edges).(k) in
  let choice =
    match s.move with
    | Edge k -> nth (fun e -> not (is_timed t.graph e)) k
    | Flow k -> nth (is_timed t.graph) k
  in
  { source = s.source; choice }

let flow_choice t i =
  match indexed (is_timed t.graph) (Graph.edges t.graph i) with
  | [||] -> None
  | timed -> Some (fst timed.(0))
