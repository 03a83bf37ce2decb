open Scc_data
open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_space
open Scc_offsets
open Scc_state_sets
open Scc_symbolic

type swarm = {
  context : Instant.context;
  model : Model.t;
  uncertain : Uncertain.t;
  initial : State.t;
  horizon : Rat.t option;
  values : Polyhedron.t;  (** of the parameters *)
  over_instants : Polyhedron.t Lazy.t array;  (** the same with so many variables more, of which nothing is said *)
  parts : Instant.part list array;  (** by process *)
  walls : bool array;
  groups : Union_find.t;  (** of processes *)
  stirred : bool array;  (** the group may have a collision, by representative *)
}

let find s = Union_find.find s.groups
let count s = Array.length s.parts
let numbers s = List.init (count s) Fun.id
let members s g = List.filter (fun i -> find s i = g) (numbers s)
let groups s = List.filter (fun i -> find s i = i && not s.walls.(i)) (numbers s)
let is_fixed s i = List.for_all (fun (p : Instant.part) -> s.model.leaves.(p.leaf).fixed) s.parts.(i)
let some_pair f one two = List.exists (fun a -> List.exists (f a) two) one

(* {1 On their lines} *)

let obstacle s (a : Instant.part) (b : Instant.part) = s.context.obstacle a.solid b.solid

(* Over the values of the parameters and so many instants more, which come last. *)
let with_instants s more =
  let n = Polyhedron.dimension s.values in
  let dimension = n + more in
  let old = Array.init n (Linear.variable dimension) in
  let lift f = Linear.compose f ~dimension old in
  let instant i = Linear.variable dimension (n + i) in
  (Lazy.force s.over_instants.(more), lift, instant, Linear.constant dimension)

let in_time s instant constant =
  Constraint.at_least instant (constant Rat.zero)
  :: List.map (fun h -> Constraint.at_most instant (constant h)) (Option.to_list s.horizon)

(* Whether two parts collide for some values: they meet up to the horizon, and their interiors do then or later. *)
let collide s (a : Instant.part) (b : Instant.part) =
  let velocity = Instant.relative_velocity a b in
  (not (Vec.is_zero velocity))
  &&
  let set, lift, instant, constant = with_instants s 2 in
  let meets = instant 0 and within = instant 1 in
  let at_facet (h : Half_space.t) =
    let lifted = { h with room = lift h.room } in
    Half_space.contact [ Half_space.after meets lifted ] @ Half_space.overlap [ Half_space.after within lifted ]
  in
  let facets = Half_space.moving (obstacle s a b) (Instant.offset a b) velocity in
  let constraints = List.concat_map at_facet facets in
  let times = Constraint.at_least within meets :: in_time s meets constant in
  not (Polyhedron.is_empty (Polyhedron.add_all set (times @ constraints)))

(* {1 After collisions} *)

let join s g h =
  ignore (Union_find.union s.groups g h);
  s.stirred.(find s g) <- true

let fly s =
  let meet i j =
    if (not (s.walls.(i) && s.walls.(j))) && some_pair (collide s) s.parts.(i) s.parts.(j) then
      if s.walls.(i) then s.stirred.(find s j) <- true
      else if s.walls.(j) then s.stirred.(find s i) <- true
      else join s i j
  in
  List.iter (fun i -> List.iter (fun j -> if i < j then meet i j) (numbers s)) (numbers s)

(* Twice the kinetic energy of a group: splits keep it, and collisions add nothing to it. *)
let energy s g =
  let of_process i =
    let p = s.initial.processes.(i) in
    match State.mass s.model p with
    | Some mass -> Rat.mul mass (Vec.norm2 p.velocity)
    | None -> Rat.zero
  in
  List.fold_left (fun e i -> Rat.add e (of_process i)) Rat.zero (members s g)

let root_above (q : Rat.t) = Rat.sqrt_above q.num q.den

(* How far at most a part gets from where it starts, up to a time: v^2 <= 2E/m. *)
let reach s ~energy ~until (p : Instant.part) =
  let leaf = s.model.leaves.(p.leaf) in
  if leaf.fixed then Rat.zero else root_above (Rat.div (Rat.mul energy (Rat.mul until until)) leaf.mass)

(* Whether a part that may be anywhere up to its reach may meet another one, which may be as far from its line, up
   to the horizon, for some values. Each plane of the obstacle is moved outward by as much. *)
let may_meet s ~until (a, of_a) (b, of_b) ~velocity =
  let set, lift, instant, constant = with_instants s 1 in
  let slack = Rat.add of_a of_b and time = instant 0 in
  let obstacle = obstacle s a b in
  let at_facet (h : Half_space.t) =
    let moved = Rat.mul slack (root_above (Vec.norm2 (Ivec.to_vec (Obstacle.facets obstacle).(h.index).normal))) in
    let room = Linear.add (lift h.room) (constant moved) in
    Half_space.needs Side.contact (Half_space.after time { h with room })
  in
  let facets = Half_space.moving obstacle (Instant.offset a b) velocity in
  let times =
    [ Constraint.at_least time (constant Rat.zero); Constraint.at_most time (constant until) ]
  in
  not (Polyhedron.is_empty (Polyhedron.add_all set (times @ List.map at_facet facets)))

(* Whether a stirred group may meet some processes of another group. Without a horizon it gets everywhere. *)
let reaches s g others =
  match s.horizon with
  | None -> true
  | Some until ->
    let of_group = energy s g in
    let reach_of i part =
      let h = find s i in
      let moves = s.stirred.(h) && not s.walls.(i) in
      (part, if moves then reach s ~energy:(energy s h) ~until part else Rat.zero)
    in
    let meets i j =
      let still = s.stirred.(find s j) || s.walls.(j) in
      let velocity = if still then Vec.zero else s.initial.processes.(j).velocity in
      let one (a : Instant.part) b =
        may_meet s ~until (a, reach s ~energy:of_group ~until a) (reach_of j b) ~velocity
      in
      (not (is_fixed s i && is_fixed s j)) && some_pair one s.parts.(i) s.parts.(j)
    in
    List.exists (fun i -> List.exists (meets i) others) (members s g)

(* Until no stirred group may meet another group. *)
let rec settle s =
  let all = groups s in
  let meets g h = g <> h && s.stirred.(g) && reaches s g (members s h) in
  let two = List.find_map (fun g -> Option.map (fun h -> (g, h)) (List.find_opt (meets g) all)) all in
  match two with
  | None -> ()
  | Some (g, h) ->
    join s g h;
    settle s

(* {1 What is left out} *)

(* The walls that a group may reach. *)
let near s g i = s.walls.(i) && s.stirred.(g) && reaches s g [ i ]

(* How many zones a group that is left out may have. *)
let patience = 200

let has_cycle graph =
  let n = Zone_graph.size graph in
  let entered = Array.make n false and left = Array.make n false in
  (* The zones that were entered and not left, with what is still to be looked at of each. *)
  let rec go = function
    | [] -> false
    | (i, []) :: above ->
      left.(i) <- true;
      go above
    | (i, (e : Zone_graph.edge) :: edges) :: above ->
      let above = (i, edges) :: above in
      if not entered.(e.target) then enter e.target above else (not left.(e.target)) || go above
  and enter i above =
    entered.(i) <- true;
    go ((i, (Zone_graph.node graph i).edges) :: above)
  in
  List.exists (fun i -> (not entered.(i)) && enter i []) (List.init n Fun.id)

(* Whether all runs of a group get to the horizon: all of its zones up to there are known, and none comes again, so
   that no run has more transitions than there are zones. *)
let lasts s g =
  Option.is_some s.horizon
  &&
  let initial = State.restricted s.initial (fun i -> find s i = g || near s g i) in
  match Start.zones s.context s.uncertain ~initial ~keeps_time:true with
  | Error _ -> false
  | Ok zones ->
    let limits = { Zone_graph.depth = None; nodes = Some patience; horizon = s.horizon; later = Followed 0 } in
    let never _ = () and no _ = false in
    let visitor = { Zone_graph.found = never; expanded = never; late = never; enough = no; stop = no } in
    let graph, end_ = Zone_graph.explore s.context ~events:[||] ~limits ~visitor zones in
    end_ = Zone_graph.Closed && not (has_cycle graph)

let kept s named =
  let wanted = Array.make (count s) false in
  List.iter (fun i -> wanted.(find s i) <- true) named;
  (* A ring may open and close for ever within an instant, without a collision. *)
  let may_go_round g = Model.closes_rings s.model && Pace.may_release s.model s.initial.processes.(g) in
  let must_last g = s.stirred.(g) || may_go_round g in
  List.iter (fun g -> if must_last g && (not wanted.(g)) && not (lasts s g) then wanted.(g) <- true) (groups s);
  let all = List.filter (fun g -> wanted.(g)) (groups s) in
  let stays i = wanted.(find s i) || List.exists (fun g -> near s g i) all in
  if List.for_all stays (numbers s) then None else Some (State.restricted s.initial stays)

let create context uncertain ~initial (z : Zone.t) formulas =
  let model = Semantics.model context.Instant.semantics in
  let processes = initial.State.processes in
  let in_events = List.concat_map Formula.leaves_of_events formulas in
  let parts (p : State.process) =
    let has (q : State.process) = State.has_leaf q p.leaves.(0).leaf in
    Instant.parts model z (List.find has (Array.to_list z.skeleton.processes))
  in
  let n = Polyhedron.dimension z.set in
  let over more = lazy (Polyhedron.embed z.set ~dimension:(n + more) (Array.init n Fun.id)) in
  {
    context; model; uncertain; initial;
    horizon = Plan.latest_horizon formulas;
    values = z.set;
    over_instants = Array.init 3 over;
    parts = Array.map parts processes;
    walls = Array.map (Slice.is_wall model ~in_events) processes;
    groups = Union_find.create (Array.length processes);
    stirred = Array.map (fun _ -> false) processes;
  }

let make context uncertain ~(initial : State.t) (z : Zone.t) formulas =
  let m = Semantics.model context.Instant.semantics in
  let owner leaf =
    let rec from i =
      if i >= Array.length initial.processes then None
      else if State.has_leaf initial.processes.(i) leaf then Some i
      else from (i + 1)
    in
    from 0
  in
  let named = List.map owner (List.concat_map Formula.leaves formulas) in
  if
    Parameters.may_push m initial
    || Model.binds_on_contact m
    || formulas = []
    || Array.length initial.processes < 2
    || (not (List.for_all Slice.can_be_sliced formulas))
    || List.exists Option.is_none named
  then None
  else begin
    let whole = { z with set = Ranges.box m.ranges } in
    let s = create context uncertain ~initial whole formulas in
    fly s;
    settle s;
    kept s (List.filter_map Fun.id named)
  end
