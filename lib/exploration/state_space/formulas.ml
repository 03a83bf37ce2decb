open Scc_ctl
open Scc_exact
open Scc_property

type asked = {
  formulas : Timed_formula.t array;
  props : Property.prop array;
  predicates : On_the_fly.predicate array;
  still : Timed_formula.t -> Timed_formula.t option;
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
  { formulas; props; predicates = Array.map (Predicate.make context) props; still }

type on = {
  graph : Timed_graph.t;
  predicates : Eval.predicates;
  number : Property.num -> int -> Rat.t -> (Rat.t, string) result;
  counted : Property.prop -> int -> int -> int * int;
}

type t = {
  asked : asked;
  on : on;
  eval : Eval.t;
  uses : Eval.uses;
  cut_short : bool ref;  (** whether the time was over for what was computed of the present formula *)
  not_exact : Scc_chance.Lifting.given_up option ref;  (** why exact values were given up for it *)
}

let predicates (a : asked) = a.predicates
let prop (a : asked) = Array.get a.props

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

let on ?(surroundings = Scc_graph_search.Limits.quiet) ?seconds asked (on : on) =
  let cut_short = ref false and not_exact = ref None in
  let effort = effort surroundings seconds cut_short not_exact in
  let eval = Eval.create ~effort ~still:asked.still (Timed_graph.index on.graph) on.predicates in
  { asked; on; eval; uses = Eval.uses eval asked.formulas; cut_short; not_exact }

let eval t = t.eval
let formula t i = t.asked.formulas.(i)
let origin = Positions.start 0
let truth t i = Eval.truth t.eval t.asked.formulas.(i) origin

let is_cut_short t = !(t.cut_short)
let not_exact t = !(t.not_exact)

let done_with t i =
  t.cut_short := false;
  t.not_exact := None;
  Eval.done_with t.eval t.uses i

let is_chain t = Eval.is_chain t.eval
let probability t i side = Eval.probability t.eval ~decide:false side t.asked.formulas.(i) origin

let curve t i side = Eval.curve t.eval side t.asked.formulas.(i) origin.node

let what t i (mean : Property.mean) : Expectation.what =
  match (mean, t.asked.formulas.(i)) with
  | Time_until _, Finally (_, _, g) -> Time_until g
  | Events_until (p, _), Until (_, _, _, g) -> Counts_until (t.on.counted p, g)
  | Value_at (n, time), _ -> Value_at (t.on.number n, time)
  | (Time_until _ | Events_until _), _ -> Scc_base.Bug.fail __POS__ "a mean with another formula"

let mean ?bound t i side mean = Expectation.find ?bound t.eval side (what t i mean)

(* Of the operators with a probability that its truth in the initial state depends on at once. *)
let probabilities t i =
  let rec go (f : Timed_formula.t) =
    match f with
    | Not f -> go f
    | And fs | Or fs -> List.concat_map go fs
    | Until (Chance { side; _ }, _, _, _) | Finally (Chance { side; _ }, _, _)
    | Globally (Chance { side; _ }, _, _) ->
      [ Eval.probability t.eval ~decide:true side f origin ]
    | Predicate _ | Next _ | Until _ | Finally _ | Globally _ -> []
  in
  go t.asked.formulas.(i)

(* What is counted until g is no condition for going on. *)
let doubts_of_mean t i =
  let until_right : Timed_formula.t -> Timed_formula.t = function
    | Until (q, b, _, g) -> Finally (q, b, g)
    | f -> f
  in
  Doubts.possible t.eval (until_right t.asked.formulas.(i)) origin

let possible_doubts t i = Doubts.possible t.eval t.asked.formulas.(i) origin
let doubts t i = Doubts.find t.eval t.asked.formulas.(i) origin

(* {1 What states have beside predicates} *)

let number_at context tuple extent n offset =
  let arrived e = Network_lts.arrived context e tuple in
  let state = Catalogue.decode (Network_lts.catalogue context) tuple in
  let semantics = Network_lts.semantics context in
  Scc_evaluate.Trajectory.number_at (Scc_evaluate.Trajectory.make ~arrived semantics state extent) n offset

let counted_by context tuple label p =
  let catalogue = Network_lts.catalogue context in
  let source = Catalogue.decode catalogue tuple in
  let n = Scc_evaluate.Counted.by (Network_lts.semantics context) ~source (Catalogue.label_of catalogue label) p in
  (n.least, n.most)
