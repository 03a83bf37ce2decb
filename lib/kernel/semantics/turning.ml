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

(* How two parts go on: which instants of time they may be seen to collide at, and how fine they lie. *)
type course = { one : Motion.t; two : Motion.t; grid : int; phase : Rat.t }

(* The grid counts from the start of the last turn that one of the two began. *)
let course c (a : Part.t) (b : Part.t) =
  let one = motion c a and two = motion c b in
  let phase =
    match (Part.turns a, Part.turns b) with
    | true, true -> Rat.min one.since two.since
    | true, false -> one.since
    | false, true -> two.since
    | false, false -> Rat.zero
  in
  { one; two; grid = Cast.grid one two ~resolution:(resolution c); phase }

(* The last instant at which they are seen to collide, if that is at most [limit]. *)
let seen c course ~limit =
  let span = Cast.next_instant ~grid:course.grid ~phase:course.phase limit in
  match c.geometry.first_penetration course.one course.two ~span ~grid:course.grid ~phase:course.phase with
  | Never -> None
  | At t -> Some t
  | Inside -> interpenetration ()

(* When neither spins, two bodies that meet at all do so at a time that is found on straight lines. *)
let on_straight_lines c (a : Part.t) (b : Part.t) =
  match c.geometry.first_time_of_contact a.placed b.placed (Part.relative_velocity a b) with
  | Never -> None
  | At t -> Some t
  | Inside -> interpenetration ()

let spins (a : Part.t) (b : Part.t) = Part.turns a || Part.turns b

(* Whether the two touch within the resolution is not asked before it matters. *)
let contact c a b =
  let time = if spins a b then seen c (course c a b) ~limit:Rat.zero else on_straight_lines c a b in
  match time with
  | Some t when Rat.sign t = 0 -> Colliding
  | Some _ | None -> Touching

let near c (a : Part.t) (b : Part.t) = c.geometry.near ~resolution:(resolution c) a.placed b.placed

let touching c a b =
  match near c a b with
  | Some near -> near.pairs
  | None -> []

(* Features whose projections to the witness plane meet are at most so far apart. *)
let bonded c ((a : Part.t), one) ((b : Part.t), two) =
  let resolution = Rat.mul (Rat.of_int 2) (resolution c) in
  Near_contact.within ~resolution (Placed.corners a.placed one) (Placed.corners b.placed two)

let first_time_of_contact c parts ~limit =
  let time ~before (a : Part.t) (b : Part.t) =
    if not (spins a b) then on_straight_lines c a b
    else
      match (before, limit) with
      | None, None -> Scc_base.Bug.fail __POS__ "time without an end where something spins"
      | Some t, None | None, Some t -> seen c (course c a b) ~limit:t
      | Some t, Some limit -> seen c (course c a b) ~limit:(Rat.min t limit)
  in
  let margin = if Option.is_some limit then margin c else Rat.zero in
  c.neighbours.earliest ~margin ~limit time parts

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
      Placed.solid = Solid.make ~id:Solid.derived cube (Mat.scale room Mat.identity);
      turned = Quaternion.identity;
      at = p.centre;
    }
  else { p.placed with solid = Placed.fixed_solid p.placed; turned = Quaternion.identity }

let never_meet ((a : Part.t), (one : Placed.t)) ((b : Part.t), (two : Placed.t)) =
  let w = Part.relative_velocity a b in
  match Obstacle.first_time_of_contact (Obstacle.make one.solid two.solid) (Vec.sub two.at one.at) w with
  | Never -> true
  | At _ | Inside -> false

let none_ahead c parts =
  let all = List.map (fun p -> (p, lazy (hull c p))) (Array.to_list parts) in
  let alone ((a : Part.t), one) ((b : Part.t), two) =
    not (a.process < b.process && Part.in_relative_motion a b)
    || never_meet (a, Lazy.force one) (b, Lazy.force two)
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
let pushed c ~at impulse p = Turn.moving c.model (Impact.pushed ~at impulse (Turn.mover c.model p)) p
let start c p = Turn.start c.model p

(* {1 Turns} *)

let time_rules = [ Rule.Time; Time_behaviour; Turn ]

let renewed c p = Turn.renew c.model p

(* What turns on from here may collide that did not, or not any more: then it is looked at again. *)
let rec at_contact c ~colliding (s : State.t) =
  if not (Array.exists Turn.goes_on s.processes) then s
  else
    let hit = colliding s in
    let ends i p = Turn.goes_on p && List.exists (Round.involves i) hit in
    if not (List.exists Fun.id (List.mapi ends (Array.to_list s.processes))) then s
    else at_contact c ~colliding (State.mapi (fun i p -> if ends i p then Turn.renew c.model p else p) s)

(* Which processes are near each other, if some may move by so much. *)
let near_each_other c ~parts (s : State.t) moves =
  let by i = Option.value (List.assoc_opt i moves) ~default:Rat.zero in
  let reach ((a : Part.t), (b : Part.t)) = Rat.add (by a.process) (by b.process) in
  let close ((a : Part.t), (b : Part.t)) =
    let reach = reach (a, b) in
    Rat.sign reach > 0 && Rat.compare (Near_contact.distance2 a.placed b.placed) (Rat.mul reach reach) <= 0
  in
  let farthest = List.fold_left (fun far (_, d) -> Rat.max far d) Rat.zero moves in
  c.neighbours.within (Rat.add farthest farthest) (parts s)
  |> List.filter close
  |> List.map (fun ((a : Part.t), (b : Part.t)) -> (a.process, b.process))

(* With the spins of free bodies for turns, but where something would collide with them. *)
let with_spins c ~colliding (s : State.t) indices =
  let midway i = Option.map (fun p -> (i, p)) (Turn.midway c.model s.processes.(i)) in
  let s, _ = Round.at_once ~colliding s (List.filter_map midway indices) in
  Round.begun c.model s indices

let begin_turns c ~parts ~colliding before =
  match Round.beginning ~colliding before with
  | [] -> (before, None)
  | indices ->
    let s, changed = Round.run c.model ~colliding ~near:(near_each_other c ~parts) before indices in
    (with_spins c ~colliding s indices, if changed then Some before else None)

let turns_rightly c (p : State.process) =
  (Turn.is_free c.model || Vec.is_zero p.kept)
  &&
  match p.lasts with
  | None -> Rat.sign p.since = 0
  | Some d when not (Turn.spinning p) -> Rat.sign p.since = 0 && Rat.sign d = 0
  | Some d ->
    Rat.sign p.since >= 0
    && Rat.compare p.since d < 0
    && Rat.compare d (Turn.length c.model p.spin) <= 0
    && (Turn.is_free c.model || Rat.equal d (Turn.length c.model p.spin))

let settled c p = Round.settled c.model p
