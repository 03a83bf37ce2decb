open Scc_ctl
open Scc_exact
open Scc_property
module Graph = State_graph

type asked = {
  context : Network_lts.context;
  formulas : Scc_ctl.Timed_formula.t array;
  props : Property.prop array;
  predicates : On_the_fly.predicate array;
  still : Scc_ctl.Timed_formula.t -> Scc_ctl.Timed_formula.t option;
}

type t = {
  asked : asked;
  graph : Graph.t;
  eval : Scc_ctl.Eval.t;
  uses : Scc_ctl.Eval.uses;
  cut_short : bool ref;  (** whether the time was over for what was computed of the present formula *)
  not_exact : Scc_chance.Lifting.given_up option ref;  (** why exact values were given up for it *)
}

(* With predicates for the times after which a goal is not met any more. *)
let ask context temporals =
  let model = Network_lts.model context in
  let times = List.sort_uniq Rat.compare (List.concat_map (Settling.last_goals model) temporals) in
  let up_to time = Property.State (Compare (Le, Quantity Time, Const time)) in
  let skeletons, props = Skeleton.of_temporal (temporals @ List.map up_to times) in
  let count = List.length temporals in
  let formulas = Array.of_list (List.filteri (fun i _ -> i < count) skeletons) in
  let guards = List.combine times (List.filteri (fun i _ -> i >= count) skeletons) in
  let still goal =
    match if guards = [] then None else Settling.temporal model (Skeleton.to_temporal (Array.get props) goal) with
    | Some { after; truth = false } ->
      Option.map snd (List.find_opt (fun (time, _) -> Rat.equal time after) guards)
    | Some { truth = true; _ } | None -> None
  in
  { context; formulas; props; predicates = Array.map (Predicate.make context) props; still }

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

(* So many products of small numbers are made in a second. *)
let in_a_second = 1 lsl 28

(* And in the time of conclusions, of which intervals have the rest. *)
let at_the_end = 1 lsl 24

(* Work that begins when the time of explorations is over has none but that of conclusions. *)
let effort (surroundings : Scc_graph_search.Limits.surroundings) seconds cut_short not_exact =
  let over (s : Scc_graph_search.Limits.surroundings) =
    let is_over () = Option.is_some (s.stop ()) in
    if is_over () then Fun.const false else is_over
  in
  let half () = over (surroundings.half ()) and quarter () = over ((surroundings.half ()).half ()) in
  let over = over surroundings in
  let interrupted () =
    let now = over () in
    if now then cut_short := true;
    now
  in
  let default = Scc_chance.Effort.default in
  let steps =
    match seconds with
    | _ when Option.is_some (surroundings.stop ()) -> at_the_end
    | Some s when s > float_of_int (default.steps / in_a_second) -> int_of_float (Float.min s 1e9) * in_a_second
    | Some _ | None -> default.steps
  in
  let not_exact why = not_exact := Some why in
  { default with Scc_chance.Effort.interrupted; half; quarter; steps; not_exact }

let on ?(surroundings = Scc_graph_search.Limits.quiet) ?seconds asked ~rests graph =
  (* Formulas are evaluated one after the other, each in all states, and may be as many as bodies. *)
  let room = Array.copy (Network_lts.initial asked.context) in
  let read node =
    Graph.read_tuple graph node room;
    room
  in
  let along p node extent =
    match asked.predicates.(p).along with
    | Some along -> along (read node) extent
    | None -> Timeline.constant extent (asked.predicates.(p).at (read node))
  in
  let predicates =
    {
      Scc_ctl.Eval.at = (fun p node -> asked.predicates.(p).at (read node));
      along;
      steady = (fun p -> Option.is_none asked.predicates.(p).along);
    }
  in
  let index = Timed_graph.index (timed_graph asked.context ~rests graph) in
  let cut_short = ref false and not_exact = ref None in
  let effort = effort surroundings seconds cut_short not_exact in
  let eval = Scc_ctl.Eval.create ~effort ~still:asked.still index predicates in
  { asked; graph; eval; uses = Scc_ctl.Eval.uses eval asked.formulas; cut_short; not_exact }

let origin = Scc_ctl.Positions.start 0
let truth t i = Scc_ctl.Eval.truth t.eval t.asked.formulas.(i) origin

let is_cut_short t = !(t.cut_short)
let not_exact t = !(t.not_exact)

let done_with t i =
  t.cut_short := false;
  t.not_exact := None;
  Scc_ctl.Eval.done_with t.eval t.uses i

let explain t i = Explanation.explain t.eval t.asked.formulas.(i) origin

let contrast t explanation = Scc_ctl.Contrast.explain t.eval explanation

let is_chain t = Scc_ctl.Eval.is_chain t.eval
let probability t i side = Scc_ctl.Eval.probability t.eval ~decide:false side t.asked.formulas.(i) origin

let curve t i side = Scc_ctl.Eval.curve t.eval side t.asked.formulas.(i) origin.node

(* At an offset of the flow of a node. *)
let number t n =
  let semantics = Network_lts.semantics t.asked.context in
  let graph = Scc_ctl.Eval.graph t.eval in
  let catalogue = Network_lts.catalogue t.asked.context in
  fun node offset ->
    let extent = Timed_graph.extent (Timed_graph.flow graph node) in
    let tuple = Graph.tuple t.graph node in
    let arrived e = Network_lts.arrived t.asked.context e tuple in
    let state = Catalogue.decode catalogue tuple in
    Scc_evaluate.Trajectory.number_at (Scc_evaluate.Trajectory.make ~arrived semantics state extent) n offset

(* The transitions of a state but for the passing of time, in the order of the graph. *)
let counted t p =
  let catalogue = Network_lts.catalogue t.asked.context and semantics = Network_lts.semantics t.asked.context in
  fun node k ->
    let source = Catalogue.decode catalogue (Graph.tuple t.graph node) in
    let _, (e : Graph.edge) = (indexed (fun e -> not (is_timed t.graph e)) (Graph.edges t.graph node)).(k) in
    let n = Scc_evaluate.Counted.by semantics ~source (Catalogue.label_of catalogue e.label) p in
    (n.least, n.most)

let what t i (mean : Property.mean) : Expectation.what =
  match (mean, t.asked.formulas.(i)) with
  | Time_until _, Finally (_, _, g) -> Time_until g
  | Events_until (p, _), Until (_, _, _, g) -> Counts_until (counted t p, g)
  | Value_at (n, time), _ -> Value_at (number t n, time)
  | (Time_until _ | Events_until _), _ -> Scc_base.Bug.fail __POS__ "a mean with another formula"

let mean ?bound t i side mean = Expectation.find ?bound t.eval side (what t i mean)

(* Of the operators with a probability that its truth in the initial state depends on at once. *)
let probabilities t i =
  let rec go (f : Scc_ctl.Timed_formula.t) =
    match f with
    | Not f -> go f
    | And fs | Or fs -> List.concat_map go fs
    | Until (Chance { side; _ }, _, _, _) | Finally (Chance { side; _ }, _, _)
    | Globally (Chance { side; _ }, _, _) ->
      [ Scc_ctl.Eval.probability t.eval ~decide:true side f origin ]
    | Predicate _ | Next _ | Until _ | Finally _ | Globally _ -> []
  in
  go t.asked.formulas.(i)

(* What is counted until g is no condition for going on. *)
let doubts_of_mean t i =
  let until_right : Scc_ctl.Timed_formula.t -> Scc_ctl.Timed_formula.t = function
    | Until (q, b, _, g) -> Finally (q, b, g)
    | f -> f
  in
  Scc_ctl.Doubts.possible t.eval (until_right t.asked.formulas.(i)) origin

let possible_doubts t i = Scc_ctl.Doubts.possible t.eval t.asked.formulas.(i) origin
let doubts t i = Scc_ctl.Doubts.find t.eval t.asked.formulas.(i) origin
let predicate t i = t.asked.props.(i)

type sensitivity = {
  temporal : t;
  parameter : Sensitivity.parameter;
  mutable known : ((Property.side * Timed_formula.t) * Scc_chance.Parametric.piece list Sensitivity.result) list;
  (** the functions of probabilities found so far: several checks may be about one *)
}

let sensitivity t range =
  let parameter = Edge_functions.make t.asked.context range ~tuple:(Graph.tuple t.graph) (Eval.graph t.eval) in
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
    let found = Sensitivity.probability s.temporal.eval s.parameter side formula in
    s.known <- ((side, formula), found) :: s.known;
    found

let probability_function s i side = probability_of s side s.temporal.asked.formulas.(i)

let mean_function { temporal = t; parameter; _ } i side mean =
  Sensitivity.mean t.eval parameter side (what t i mean)

let where ({ temporal = t; parameter; _ } as s) i =
  Sensitivity.where t.eval parameter ~probability:(probability_of s) t.asked.formulas.(i)

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
