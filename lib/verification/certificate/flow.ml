open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_state_sets
open Arrangement

type t = { states : Polyhedron.t; ends : Zone.t }

let where region constraints =
  let p = Polyhedron.add_all region constraints in
  if Polyhedron.is_empty p then [] else [ p ]

let zero_like f = Linear.constant (Linear.dimension f) Rat.zero

(* {1 Delays and clocks} *)

let delays_of c (z : Zone.t) (l : State.leaf) =
  let m = Semantics.model c.semantics in
  let length : Behaviour.t -> Linear.t = function
    | Delay (t, _) -> Linear.constant (Zone.dimension z) t
    | Wait (f, _) -> Linear.compose f ~dimension:(Zone.dimension z) z.parameters
    | Nil | Open _ | Weak _ | Strong _ | Sum _ | Call _ -> Scc_base.Bug.fail __POS__ "no delay"
  in
  List.map (fun d -> Linear.sub (length d) z.ages.(l.leaf)) (Behaviours.delays m.definitions l.behaviour)

let leaves (z : Zone.t) =
  List.concat_map (fun (p : State.process) -> Array.to_list p.leaves) (Array.to_list z.skeleton.processes)

(* What is left until the next split instants. *)
let clocks c (z : Zone.t) =
  match (Semantics.model c.semantics).splits with
  | Any_time -> []
  | Every step ->
    let left (p : State.process) =
      let clock = z.clocks.(p.leaves.(0).leaf) in
      Option.map (fun _ -> Linear.sub (Linear.constant (Linear.dimension clock) step) clock) p.clock
    in
    List.filter_map left (Array.to_list z.skeleton.processes)

let delays c z = List.concat_map (delays_of c z) (leaves z)

(* {1 Ways} *)

let moving c z =
  let apart (a, b) = a.process <> b.process && not (Vec.is_zero (Vec.sub b.velocity a.velocity)) in
  List.filter apart (Scc_data.Lists.pairs (parts c z)) |> List.map (facets c)

(* The conditions of which one holds iff two parts do not collide before the end: over the start, where the time
   that passes is the last variable. *)
let free n facets =
  let time = Linear.variable n (n - 1) in
  let not_inside h = Constraint.negation (Half_space.needs Side.overlap h) in
  let alone (h : Half_space.t) = not_inside (if Rat.sign h.speed < 0 then Half_space.after time h else h) in
  let { Half_space.entered; left; _ } = Half_space.passage facets in
  let late e = List.map (fun l -> Constraint.at_least (Half_space.crossing e) (Half_space.crossing l)) left in
  List.concat_map alone facets @ List.concat_map late entered

let passings c (z : Zone.t) region =
  let n = Zone.dimension z + 1 in
  let old = Array.init (n - 1) (Linear.variable n) in
  let time = Linear.variable n (n - 1) in
  let set = Polyhedron.embed region ~dimension:n (Array.init (n - 1) Fun.id) in
  let start = Zone.with_variables z ~dimension:n old set in
  let left = delays c start @ clocks c start in
  let in_time = Constraint.greater time (zero_like time) :: List.map (Constraint.at_most time) left in
  let pass regions facets =
    let conditions = free n facets in
    let of_region p =
      if List.exists (Polyhedron.implies p) conditions then [ p ]
      else List.concat_map (fun k -> where p [ k ]) conditions
    in
    List.concat_map of_region regions
  in
  let regions = List.fold_left pass (where start.set in_time) (moving c start) in
  let ages = Array.copy start.ages and clocks = Array.copy start.clocks and places = Array.copy start.places in
  let on_grid = match (Semantics.model c.semantics).splits with Every _ -> true | Any_time -> false in
  let of_process (p : State.process) =
    let of_leaf (l : State.leaf) =
      places.(l.leaf) <- Place.moved places.(l.leaf) p.velocity time;
      if delays_of c start l <> [] then ages.(l.leaf) <- Linear.add ages.(l.leaf) time
    in
    Array.iter of_leaf p.leaves;
    let first = p.leaves.(0).leaf in
    if Option.is_some p.clock && on_grid then clocks.(first) <- Linear.add clocks.(first) time
  in
  Array.iter of_process start.skeleton.processes;
  List.map (fun set -> { states = set; ends = { start with set; arrived = []; ages; clocks; places } }) regions

let contacts c { states; ends } =
  List.concat_map (fun facets -> where states (Half_space.collision facets)) (moving c ends)
