open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_rigid
open Kinematics

(* {1 Contact} *)

let parts { model; _ } process (owner : State.process) =
  let centre = State.centre_of_mass model owner in
  let of_leaf (leaf : State.leaf) =
    List.init (Array.length model.leaves.(leaf.leaf).parts) (fun index ->
        { Part.process; owner; leaf; index; placed = State.placed model leaf index; centre })
  in
  List.concat_map of_leaf (Array.to_list owner.leaves)

let motion c (p : Part.t) = Turn.motion c.model p.owner ~centre:p.centre p.leaf p.index
let resolution c = (Turn.rigid c.model).resolution
let margin = resolution
let interpenetration () = Scc_base.Bug.fail __POS__ "two bodies interpenetrate"

(* 2^-K, the length of a cell of the grid of instants. *)
let cell grid = Rat.make Z.one (Z.shift_left Z.one grid)
let grid c a b = Cast.grid (motion c a) (motion c b) ~resolution:(resolution c)

let cast c a b ~span ~grid =
  match c.geometry.first_penetration (motion c a) (motion c b) ~span ~grid with
  | Never -> None
  | At t -> Some t
  | Inside -> interpenetration ()

(* Whether the two touch within the resolution is not asked before it matters. *)
let contact c a b =
  let grid = grid c a b in
  if Option.is_some (cast c a b ~span:(cell grid) ~grid) then Colliding else Touching

let near c (a : Part.t) (b : Part.t) = c.geometry.near ~resolution:(resolution c) a.placed b.placed

let touching c a b =
  match near c a b with
  | Some near -> near.pairs
  | None -> []

(* Features whose projections to the witness plane meet are at most so far apart. *)
let bonded c ((a : Part.t), one) ((b : Part.t), two) =
  let resolution = Rat.mul (Rat.of_int 2) (resolution c) in
  Near_contact.within ~resolution (Placed.corners a.placed one) (Placed.corners b.placed two)

let within_span c parts span =
  let time ~before a b =
    let grid = grid c a b in
    (* what would be earlier than [before] begins to interpenetrate before this *)
    let span = match before with None -> span | Some t -> Rat.min span (Rat.add t (cell grid)) in
    cast c a b ~span ~grid
  in
  c.neighbours.earliest ~margin:(margin c) ~limit:(Some span) time parts

(* When nothing spins, two bodies that meet at all do so at a time that is found on straight lines. *)
let on_straight_lines c ~before:_ (a : Part.t) (b : Part.t) =
  match c.geometry.first_time_of_contact a.placed b.placed (Part.relative_velocity a b) with
  | Never -> None
  | At t -> Some t
  | Inside -> interpenetration ()

let first_time_of_contact c parts ~limit =
  match limit with
  | Some span -> within_span c parts span
  | None ->
    let meets = c.neighbours.earliest ~margin:Rat.zero ~limit (on_straight_lines c) parts in
    Option.bind meets (fun t -> within_span c parts (Rat.add t Rat.one))

(* {1 Rule Quiescent} *)

let cube =
  let vertex i =
    let side bit = if i land bit = 0 then -1 else 1 in
    (Printf.sprintf "v%d" i, Vec.of_ints (side 1) (side 2) (side 4))
  in
  let faces =
    [ [ 0; 2; 3; 1 ]; [ 4; 5; 7; 6 ]; [ 0; 4; 6; 2 ]; [ 1; 3; 7; 5 ]; [ 0; 1; 5; 4 ]; [ 2; 6; 7; 3 ] ]
  in
  let face i corners = (Printf.sprintf "f%d" i, Array.of_list corners) in
  let set =
    {
      Polyhedron.ifs_vertices = Array.init 8 vertex;
      ifs_faces = Array.of_list (List.mapi face faces);
    }
  in
  match Polyhedron.of_ifs set with
  | Ok cube -> cube
  | Error _ -> Scc_base.Bug.fail __POS__ "a cube is no convex polyhedron"

(* A solid that only moves in a straight line and never leaves a part outside: the part itself if it does not spin,
   else a cube about the ball that it turns in, with room for more than the resolution. *)
let hull c (p : Part.t) =
  if Part.turns p then
    let room = Rat.add (Part.reach p) (Rat.mul (Rat.of_int 2) (resolution c)) in
    {
      Placed.solid = Solid.make ~id:0 cube (Mat.scale room Mat.identity);
      turned = Quaternion.identity;
      at = p.centre;
    }
  else { p.placed with solid = Placed.fixed_solid p.placed; turned = Quaternion.identity }

let never_meet c ((a : Part.t), (b : Part.t)) =
  let one = hull c a and two = hull c b in
  let w = Part.relative_velocity a b in
  match Obstacle.first_time_of_contact (Obstacle.make one.solid two.solid) (Vec.sub two.at one.at) w with
  | Never -> true
  | At _ | Inside -> false

let none_ahead c parts =
  let all = Array.to_list parts in
  let alone (a : Part.t) (b : Part.t) =
    not (a.process < b.process && Part.in_relative_motion a b) || never_meet c (a, b)
  in
  List.for_all (fun a -> List.for_all (alone a) all) all

(* {1 What happens to processes} *)

let bounce c processes meetings =
  let encounter (m : meeting) : Impact.encounter =
    let contacts = List.filter_map (fun (a, b) -> near c a b) m.touching in
    { one = m.first; two = m.second; contacts }
  in
  Impact.bounce_all (Array.map (Turn.mover c.model) processes) (List.map encounter meetings)
  |> Option.map (fun after -> Array.map2 (Turn.moving c.model) after processes)

let joined { model; _ } p q whole =
  Turn.moving model (Impact.bind [ Turn.mover model p; Turn.mover model q ]) whole

let piece c ~whole p = Turn.piece c.model ~whole p
let start c p = Turn.start c.model p

(* {1 Steps} *)

let time_rules = [ Rule.Time; Time_behaviour; Turn ]
let step_needs_law = false

let stale c (s : State.t) =
  let turning (p : State.process) = Rat.sign p.since > 0 in
  Turn.is_free c.model || Array.exists turning s.processes

let renewed c (s : State.t) =
  State.make ~processes:(List.map (Turn.renew c.model) (Array.to_list s.processes)) ~step:s.step ~time:s.time

let step_length c s = Turn.step_length c.model s

(* The spins of the turns that begin, unless something would collide with them that does not otherwise. *)
let with_spins c ~collides (s : State.t) =
  if not (Turn.is_free c.model) then s
  else
    let d = step_length c s in
    let processes = List.map (Turn.midway c.model d) (Array.to_list s.processes) in
    let turning = State.make ~processes ~step:s.step ~time:s.time in
    if collides turning then s else turning

let all_parts c (s : State.t) = Array.of_list (List.concat (List.mapi (parts c) (Array.to_list s.processes)))

(* Whether a process is farther than a distance from every other one. *)
let apart c s process ~by =
  let near ((a : Part.t), (b : Part.t)) =
    (a.process = process || b.process = process)
    && Rat.compare (Near_contact.distance2 a.placed b.placed) (Rat.mul by by) <= 0
  in
  not (List.exists near (c.neighbours.within by (all_parts c s)))

let begin_step c ~collides s =
  let before = with_spins c ~collides s in
  let rounded, changed = Round.run c.model ~collides ~apart:(apart c) before in
  (rounded, if changed then Some before else None)
let shortened = Turn.shortened

let turns_rightly c (p : State.process) =
  (Turn.is_free c.model || Vec.is_zero p.kept)
  && (Rat.sign p.since = 0 || (Rat.sign p.since > 0 && Turn.spinning p))

let settled c p = Round.settled c.model p
