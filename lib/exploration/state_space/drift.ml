open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_property

type t = {
  model : Model.t;
  may_push : Behaviour.t -> bool;  (** what it releases, now or later *)
  coordinates : (Vec.t * int * Places_seen.limits) list;  (** along a direction *)
  distances : (int, Places_seen.limits) Hashtbl.t array;  (** by a leaf, and by the other one *)
  bodies : Recession.body Lazy.t array;  (** of a leaf, about its reference point *)
  fence : (Vec.t * Rat.t) list option;
  (** the convex hull of all that is fixed, as n.p <= h: who is in it is not apart from that *)
}

(** {1 Where it is used} *)

let has_prefix (m : Model.t) (s : State.t) is =
  let in_term = Behaviour.some_prefix m.definitions ~behind:(fun _ -> true) is in
  let leaf_has (l : State.leaf) = in_term l.behaviour.term in
  Array.exists (fun (p : State.process) -> Array.exists leaf_has p.leaves) s.processes

(* Without a law, only what is told here happens to bodies that meet nobody for ever. *)
let goes_on : Behaviour.t -> bool = function
  | Weak _ | Delay _ | Wait _ -> true
  | Nil | Open _ | Strong _ | Sum _ | Call _ -> false

let body (leaf : Model.leaf) =
  let corners (p : Model.part) =
    List.init (Array.length p.solid.Solid.vertices) (fun i -> Vec.add p.offset (Solid.vertex p.solid i))
  in
  Recession.body (Array.of_list (List.concat_map corners (Array.to_list leaf.parts)))

let is_fixed (m : Model.t) (p : State.process) =
  Array.exists (fun (l : State.leaf) -> m.leaves.(l.leaf).fixed) p.leaves

let bodies_of known (p : State.process) =
  List.map (fun (l : State.leaf) -> (l.position, Lazy.force known.(l.leaf))) (Array.to_list p.leaves)

let corners (place, (body : Recession.body)) = List.map (Vec.add place) (Array.to_list body.corners)

let fence m known (s : State.t) =
  let fixed = List.filter (is_fixed m) (Array.to_list s.processes) in
  let points = Array.of_list (List.concat_map corners (List.concat_map (bodies_of known) fixed)) in
  let plane corners =
    let at i = points.(corners.(i)) in
    let n = Vec.cross (Vec.sub (at 1) (at 0)) (Vec.sub (at 2) (at 0)) in
    (n, Vec.dot n (at 0))
  in
  Option.map (List.map plane) (Hull.triangles points)

(* A corner of it is within. *)
let is_inside known planes (p : State.process) =
  let is_within corner = List.for_all (fun (n, h) -> Rat.compare (Vec.dot n corner) h <= 0) planes in
  List.exists (fun body -> List.exists is_within (corners body)) (bodies_of known p)

let is_held d (p : State.process) =
  match d.fence with
  | None -> false
  | Some planes -> is_fixed d.model p || is_inside d.bodies planes p

let pushing : Behaviour.t -> bool = function
  | Weak (_, { push; _ }, _) | Strong (_, push, _) -> Rat.sign push > 0
  | Nil | Open _ | Delay _ | Wait _ | Sum _ | Call _ -> false

let by_leaf (m : Model.t) distances =
  let known = Array.map (fun _ -> Hashtbl.create 1) m.leaves in
  let add (i, j, limits) =
    Hashtbl.replace known.(i) j limits;
    Hashtbl.replace known.(j) i limits
  in
  List.iter add distances;
  known

let make (m : Model.t) (initial : State.t) checks =
  let on_a_grid = match m.splits with Every _ -> true | Any_time -> false in
  let seen = Places_seen.checks m checks in
  if m.steered || Model.has_turns m || (not on_a_grid) || Places_seen.everything seen then None
  else
    let bodies = Array.map (fun leaf -> lazy (body leaf)) m.leaves in
    let fence = fence m bodies initial in
    (* Nobody collides for ever without something fixed. *)
    if not (has_prefix m initial goes_on || Option.is_some fence) then None
    else
      let may_push = has_prefix m initial pushing in
      Some
        {
          model = m;
          may_push =
            (fun term -> may_push && Behaviour.some_prefix m.definitions ~behind:(fun _ -> true) pushing term);
          coordinates = Places_seen.coordinates seen;
          distances = by_leaf m (Places_seen.distances seen);
          bodies; fence;
        }

(** {1 Groups} *)

type sums = {
  movable : int;  (** leaves that are not fixed; all that follows is of these *)
  mass : Rat.t;
  least : Rat.t;  (** the mass of the lightest *)
  momentum : Vec.t;
  energy : Rat.t;  (** twice the kinetic one *)
}

type group = {
  members : int list;  (** processes, by their places in the state *)
  leaves : int list;
  anchored : bool;  (** it is not moved: something in it is fixed, or where it is can be seen *)
  pushes : bool;
  sums : sums;
  bodies : (Vec.t * Recession.body) list;
  velocity : Vec.t;  (** of its centre of mass; 0 if anchored: it takes momentum from what is fixed *)
  spread2 : Rat.t option;
  (** none of its leaves ever moves faster against that velocity than the root of this; [None]: nothing is known *)
}

let nothing = { movable = 0; mass = Rat.zero; least = Rat.zero; momentum = Vec.zero; energy = Rat.zero }

let add a b =
  {
    movable = a.movable + b.movable;
    mass = Rat.add a.mass b.mass;
    least =
      (match (a.movable, b.movable) with 0, _ -> b.least | _, 0 -> a.least | _ -> Rat.min a.least b.least);
    momentum = Vec.add a.momentum b.momentum;
    energy = Rat.add a.energy b.energy;
  }

(* Where the momentum stays, a leaf of mass m in a group of mass M has at most the share (M - m)/M of the energy in
   the frame of the centre of mass. A group of one leaf releases nothing. *)
let with_motion g =
  let s = g.sums in
  let velocity =
    if g.anchored || s.movable = 0 then Vec.zero else Vec.scale (Rat.div Rat.one s.mass) s.momentum
  in
  let spread2 =
    if s.movable = 0 then Some Rat.zero
    else if g.pushes && List.compare_length_with g.leaves 1 > 0 then None
    else if g.anchored then Some (Rat.div s.energy s.least)
    else
      let inner = Rat.sub s.energy (Rat.mul s.mass (Vec.norm2 velocity)) in
      Some (Rat.div (Rat.mul inner (Rat.sub s.mass s.least)) (Rat.mul s.least s.mass))
  in
  { g with velocity; spread2 }

let single d i (p : State.process) =
  let of_leaf (l : State.leaf) =
    let leaf = d.model.leaves.(l.leaf) in
    if leaf.fixed then nothing
    else
      {
        movable = 1;
        mass = leaf.mass;
        least = leaf.mass;
        momentum = Vec.scale leaf.mass p.velocity;
        energy = Rat.mul leaf.mass (Vec.norm2 p.velocity);
      }
  in
  let leaves = Array.to_list p.leaves in
  with_motion
    {
      members = [ i ];
      leaves = List.map (fun (l : State.leaf) -> l.leaf) leaves;
      anchored = is_fixed d.model p;
      pushes = List.exists (fun (l : State.leaf) -> d.may_push l.behaviour.term) leaves;
      sums = List.fold_left (fun sums l -> add sums (of_leaf l)) nothing leaves;
      bodies = bodies_of d.bodies p;
      velocity = Vec.zero;
      spread2 = None;
    }

let join g h =
  with_motion
    {
      g with
      members = List.rev_append g.members h.members;
      leaves = List.rev_append g.leaves h.leaves;
      anchored = g.anchored || h.anchored;
      pushes = g.pushes || h.pushes;
      sums = add g.sums h.sums;
      bodies = List.rev_append g.bodies h.bodies;
    }

(** {1 Apart for ever} *)

let has g leaf = List.exists (Int.equal leaf) g.leaves

(* Above which squared distance nobody can tell any more how far two groups are from each other; [None]: there is
   none. *)
let limit d g h =
  let greater known i j =
    match (known, Hashtbl.find_opt d.distances.(i) j) with
    | None, _ | _, Some Places_seen.All -> None
    | Some a, Some (Between (_, high)) -> Some (Rat.max a high)
    | Some _, None -> known
  in
  let to_others known i =
    if Hashtbl.length d.distances.(i) = 0 then known
    else List.fold_left (fun known j -> greater known i j) known h.leaves
  in
  List.fold_left to_others (Some Rat.zero) g.leaves

let apart d g h =
  (not (g.anchored && h.anchored))
  &&
  match (g.spread2, h.spread2) with
  | Some a, Some b -> (
      let one = { Recession.bodies = g.bodies; velocity = g.velocity; spread2 = a } in
      let two = { Recession.bodies = h.bodies; velocity = h.velocity; spread2 = b } in
      let by margin = Recession.for_ever ~margin one two in
      (* Which distances are asked about takes longer to see. *)
      by Rat.zero
      &&
      match limit d g h with
      | Some limit -> Rat.sign limit = 0 || by (Rat.root limit)
      | None -> false)
  | None, _ | _, None -> false

(* All of its coordinates that are compared with constants are beyond these, and stay so. *)
let settled d g =
  let is_settled (n, leaf, (limits : Places_seen.limits)) =
    match (limits, g.spread2) with
    | _, _ when not (has g leaf) -> true
    | Between (low, high), Some s ->
      let v = Vec.dot n g.velocity and first, last = Recession.range g.bodies n in
      Recession.exceeds (Rat.mul v v) (Rat.mul s (Vec.norm2 n)) Rat.zero
      && if Rat.sign v > 0 then Rat.compare first high > 0 else Rat.compare last low < 0
    | All, _ | _, None -> false
  in
  List.for_all is_settled d.coordinates

let anchor d g = if g.anchored || settled d g then g else with_motion { g with anchored = true }

(* The finest partition into groups that are apart for ever. *)
let rec insert d g groups =
  match List.find_opt (fun h -> not (apart d g h)) groups with
  | None -> g :: groups
  | Some h -> insert d (anchor d (join g h)) (List.filter (fun k -> k != h) groups)

let partition d processes =
  let add (i, groups) p = (i + 1, insert d (anchor d (single d i p)) groups) in
  snd (Array.fold_left add (0, []) processes)

let groups d processes =
  let members g = List.sort Int.compare g.members in
  List.sort (List.compare Int.compare) (List.map members (partition d processes))

let sees_far m (initial : State.t) checks =
  Places_seen.for_ever (Places_seen.checks m checks)
  &&
  match make m initial [] with
  | None -> false
  | Some d -> List.compare_length_with (groups d initial.processes) 1 > 0

(** {1 Where they are placed} *)

let moved by g = { g with bodies = List.map (fun (place, body) -> (Vec.add place by, body)) g.bodies }

let rec all_apart d = function
  | [] -> true
  | g :: rest -> List.for_all (apart d g) rest && all_apart d rest

(* Where it comes to at a time, if its first leaf is in the origin at 0. *)
let shift time g =
  let first least (place, _) = if Vec.compare place least < 0 then place else least in
  Vec.sub (Vec.scale time g.velocity) (List.fold_left first (fst (List.hd g.bodies)) g.bodies)

(* Bits. Where velocities are longer, they grow, so that states do not recur; and each comparison takes long.
   States of which one stands for the other have the same velocities. *)
let long = 128

let place d processes =
  let is_long (p : State.process) = Vec.bits p.velocity > long in
  let left_alone = Array.for_all (is_held d) processes || Array.exists is_long processes in
  let groups = if left_alone then [] else partition d processes in
  let anchored, free = List.partition (fun g -> g.anchored) groups in
  let rec at time =
    let shifts = List.map (shift time) free in
    let there = List.map2 moved shifts free in
    if List.for_all (settled d) there && all_apart d (anchored @ there) then
      List.concat (List.map2 (fun g by -> List.map (fun i -> (i, by)) g.members) free shifts)
    else at (Rat.add time time)
  in
  match free with [] -> [] | _ :: _ -> at Rat.one

let keeps d processes (q : Property.quantity) =
  let groups = lazy (partition d processes) in
  let home leaf = List.find_opt (fun g -> has g leaf) (Lazy.force groups) in
  match q with
  | Position (_, i) -> Option.fold ~none:true ~some:(fun g -> g.anchored) (home i)
  | Distance2 (i, j) -> Option.fold ~none:true ~some:(fun g -> has g j || Option.is_none (home j)) (home i)
  | Bonds _ | Size _ | Processes | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Momentum _ | Angular _ | Energy
  | Time | Parameter _ -> true
