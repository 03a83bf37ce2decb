(* The first penetration of turning solids: cases solved by hand, casts without turning against {!Obstacle},
   symmetries, and the relation of the solids before and after the instant that is found. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
open Bodies
module Data = Scc_test_data.Test_data

let solid_of plain = Data.solid ~id:0 plain Mat.identity
let box x y z = solid_of (Solids.box x y z)
let small_cube = lazy (box 1 1 1)
let floor = lazy (box 10 10 1)
let about_z = Vec.make Rat.zero Rat.zero

let body ?(turned = Quaternion.identity) ?(arm = Vec.zero) ?(velocity = Vec.zero) ?(spin = Vec.zero)
    ?(since = Rat.zero) solid centre =
  { Motion.solid; turned; arm; centre; velocity; spin; since }

let word = function Sweep.Never -> "never" | At t -> Algebraic.to_string t

let equal x y =
  match (x, y) with
  | Sweep.Never, Sweep.Never -> true
  | At s, At t -> Algebraic.equal s t
  | (Never | At _), _ -> false

let same name expected found =
  if not (equal expected found) then Alcotest.failf "%s: %s instead of %s" name (word found) (word expected)

let at t = Sweep.At (Algebraic.of_rat t)

let first_root coefficients =
  let p = Polynomial.of_coefficients (List.map Rat.of_int coefficients) in
  List.hd (Algebraic.roots p ~low:Rat.zero ~high:None)

(* Both ways round. *)
let check ?(from = Rat.zero) ?(until = Rat.one) name expected a b =
  same name expected (Sweep.first_penetration a b ~from ~until);
  same (name ^ ", swapped") expected (Sweep.first_penetration b a ~from ~until)

let touches name a b t =
  Alcotest.(check bool) name true (Sweep.relation a b t = Obstacle.Touching)

let resting () =
  let floor = body (Lazy.force floor) Vec.zero in
  let cube ?since ?velocity spin = body ?since ?velocity (Lazy.force small_cube) (v 0 0 2) ~spin in
  let half = ratio 1 2 in
  check "at rest" Never (cube Vec.zero) floor;
  check "spinning flat" Never (cube (about_z half)) floor;
  check "spinning flat, after a while" Never (cube ~since:(ratio 5 7) (about_z half)) floor;
  check "spinning and sliding" Never (cube ~velocity:(v 3 2 0) (about_z half)) floor;
  check "spinning, sliding, rising" Never (cube ~velocity:(v 3 2 1) (about_z half)) floor;
  check "spinning and sinking" (at Rat.zero) (cube ~velocity:(v 3 2 (-1)) (about_z half)) floor;
  check "tipping" (at Rat.zero) (cube (v 1 0 0)) floor;
  let slowly = Vec.make Rat.zero Rat.zero half in
  check "tipping while it rises slowly" (at Rat.zero) (cube ~velocity:slowly (v 1 0 0)) floor;
  check "over the edge" Never (cube ~velocity:(v 40 0 0) (about_z half)) floor;
  let slab = { floor with spin = about_z (Rat.neg half) } in
  check "both spinning" Never (cube (about_z half)) slab;
  (* over a part of the floor, and only along its edge *)
  let far = body (Lazy.force small_cube) (v 10 0 2) ~velocity:(v 3 0 (-1)) in
  check "past the edge" (at Rat.zero) far floor;
  check "past the edge, sinking from there on" Never { far with centre = v 11 0 2 } floor

(* An octahedron on its tip: it stands, it rolls to the side, it turns into the floor. *)
let on_the_tip () =
  let floor = body (Lazy.force floor) (v 0 0 (-2)) in
  let tip ?arm ?(centre = Vec.zero) ?velocity spin = body ?arm ?velocity (named "octahedron") centre ~spin in
  check "turning about the tip" Never (tip (v 0 0 2)) floor;
  check "turning about the centre" Never (tip (v 1 0 0)) floor;
  let above h = Vec.make Rat.zero Rat.zero h in
  let rolling sign = tip ~arm:(above Rat.one) ~centre:(above (Rat.of_int (-1))) (v sign 0 0) in
  (* an edge at 45 degrees comes down: t = 2 tan(45/2) = 2 sqrt 2 - 2 *)
  let root = first_root [ -4; 4; 1 ] in
  check "about the tip, until an edge lies on the floor" (Sweep.At root) (rolling 1) floor;
  check "the other way" (Sweep.At root) (rolling (-1)) floor;
  check "lower after a while" (at Rat.zero) (tip (v 1 0 0) ~velocity:(above (ratio (-1) 100))) floor;
  (* the tip is at height (1 - cos a), of second order in t: it penetrates when the centre sinks at all *)
  touches "stands" (tip (v 1 0 0)) floor Rat.zero

(* A rod of length 10 and width 2 turns about its centre, spin 1, towards a wall at distance h: with u = t/2
   its lowest corner is at -(10 u + 1 - u^2)/(1 + u^2). *)
let rod_and_wall () =
  let rod = body (box 5 1 1) Vec.zero ~spin:(v 0 0 1) in
  let wall h = body (box 10 1 10) (Vec.make Rat.zero (Rat.neg (Rat.add h Rat.one)) Rat.zero) in
  let root = first_root [ 2; -5; 1 ] in
  check "irrational" (Sweep.At root) rod (wall (Rat.of_int 3));
  check "rational" (at (ratio 2 5)) rod (wall (ratio 37 13));
  touches "then" rod (wall (ratio 37 13)) (ratio 2 5);
  check "the end is too early" Never rod (wall (ratio 37 13)) ~until:(ratio 2 5);
  check "from the instant on" (at (ratio 2 5)) rod (wall (ratio 37 13)) ~from:(ratio 2 5);
  check "an empty interval" Never rod (wall (ratio 37 13)) ~from:(ratio 2 5) ~until:(ratio 2 5);
  check "inside already" (at (ratio 1 2)) rod (wall (ratio 37 13)) ~from:(ratio 1 2);
  check "backwards" (at (ratio 2 5)) { rod with spin = v 0 0 (-1) } (wall (ratio 37 13));
  check "with a wall that turns away" Never rod { (wall (ratio 37 13)) with velocity = v 0 (-9) 0 };
  (* the turn began 1/5 ago *)
  check "since" (at (ratio 1 5)) { rod with since = ratio 1 5 } (wall (ratio 37 13));
  (* a quarter turn of the shape instead of a rod across *)
  let quarter = Quaternion.make Z.one Z.zero Z.zero Z.one in
  let up = body (box 1 5 1) Vec.zero ~spin:(v 0 0 1) ~turned:quarter in
  check "turned" (at (ratio 2 5)) up (wall (ratio 37 13));
  (* the reference point is not the centre *)
  let arm = v 3 (-2) 1 in
  let moved = Data.solid ~id:0 (Solids.Naive.move Mat.identity (Vec.neg arm) (Solids.box 5 1 1)) Mat.identity in
  check "arm" (at (ratio 2 5)) (body moved Vec.zero ~spin:(v 0 0 1) ~arm) (wall (ratio 37 13))

(* The corner of a 6 by 8 plate, 5 from its centre, is lowest when u = 1/3. *)
let grazes () =
  let plate = body (box 3 4 1) Vec.zero ~spin:(v 0 0 1) in
  let wall h = body (box 10 1 10) (Vec.make Rat.zero (Rat.neg (Rat.add h Rat.one)) Rat.zero) in
  check "graze" Never plate (wall (Rat.of_int 5));
  touches "at the graze" plate (wall (Rat.of_int 5)) (ratio 2 3);
  check "from the graze on" Never plate (wall (Rat.of_int 5)) ~from:(ratio 2 3);
  check "nearer" (at Rat.zero) plate (wall (Rat.of_int 4));
  (match Sweep.first_penetration plate (wall (ratio 4999 1000)) ~from:Rat.zero ~until:Rat.one with
   | Never -> Alcotest.fail "deeper than a graze"
   | At t -> Alcotest.(check bool) "before" true (Algebraic.compare_rat t (ratio 2 3) < 0));
  (* two such plates graze each other corner to corner, turning in opposite senses *)
  let other = body (box 3 4 1) (v 0 (-10) 0) ~spin:(v 0 0 (-1)) in
  touches "corners" plate other (ratio 2 3);
  check "corner to corner" Never plate other;
  let cube c = body (Lazy.force small_cube) c in
  check "edge along edge" Never (cube Vec.zero) { (cube (v 1 3 0)) with velocity = v 2 (-2) 0 };
  check "corner past corner" Never (cube Vec.zero) { (cube (v 1 3 1)) with velocity = v 2 (-2) 2 };
  check "edge onto edge" (at (ratio 1 2)) (cube Vec.zero) { (cube (v 3 3 0)) with velocity = v (-2) (-2) 0 };
  check "corner onto corner" (at (ratio 1 2)) (cube Vec.zero)
    { (cube (v 3 3 3)) with velocity = v (-2) (-2) (-2) };
  check "face onto face" (at (ratio 1 2)) (cube Vec.zero) { (cube (v 3 0 0)) with velocity = v (-2) 0 0 }

(* {1 Without turning} *)

let without_turning a b ~until =
  let o = Obstacle.make a.Motion.solid b.Motion.solid in
  match Obstacle.first_time_of_contact o (Vec.sub b.centre a.centre) (Vec.sub b.velocity a.velocity) with
  | Obstacle.At t when Rat.compare t until < 0 -> at t
  | At _ | Never -> Never
  | Inside -> at Rat.zero

let casts shape file stride () =
  let path name = "../../data/geometry/" ^ name in
  let a = solid_of (Data.shape (path shape)) in
  Array.iteri
    (fun i (c : Data.case) ->
       if i mod stride = 0 then begin
         let a = body a Vec.zero and b = body (Solid.make ~id:1 a.polyhedron c.turn) c.far ~velocity:c.velocity in
         let until = Rat.of_int 3 in
         let found = Sweep.first_penetration a b ~from:Rat.zero ~until in
         let expected = without_turning a b ~until in
         if not (equal found expected) then
           Alcotest.failf "%s, pair %d: %s instead of %s" file (i + 1) (word found) (word expected)
       end)
    (Data.pairs (path file))

let scene_bodies (s : Solids.scene) =
  (body (Solids.solid ~id:0 s.a) Vec.zero, body (Solids.solid ~id:1 s.b) s.r ~velocity:s.w)

let cast name gen =
  Solids.property name ~count:60 ~gen (fun s ->
      let a, b = scene_bodies s in
      let until = Rat.of_int 2 in
      let found = Sweep.first_penetration a b ~from:Rat.zero ~until and expected = without_turning a b ~until in
      equal found expected || QCheck2.Test.fail_reportf "%s instead of %s" (word found) (word expected))

(* {1 Turning} *)

let triples k = Gen.map (fun (x, y, z) -> v x y z) Gen.(triple (-k -- k) (-k -- k) (-k -- k))

let spin =
  let axis = Gen.oneofl [ v 1 0 0; v 0 1 0; v 0 0 1; v 0 0 (-1) ] in
  let about_axis = Gen.map2 (fun n a -> Vec.scale (ratio n 3) a) Gen.(-3 -- 3) axis in
  let quarters = Gen.map (Vec.scale (ratio 1 4)) (triples 4) in
  Gen.frequency [ (1, Gen.return Vec.zero); (2, about_axis); (2, quarters) ]

let moving centre =
  let small = Gen.map (Vec.scale (ratio 1 2)) (triples 1) in
  let since = Gen.oneofl [ Rat.zero; Rat.zero; ratio 1 4; ratio 2 3 ] in
  Gen.map2
    (fun (solid, turned, centre) (arm, velocity, spin, since) ->
       { Motion.solid; turned; arm; centre; velocity; spin; since })
    (Gen.triple solid turn centre)
    (Gen.quad (Gen.oneof [ Gen.return Vec.zero; small ]) small spin since)

(* B flies towards A. *)
let meeting =
  Gen.map
    (fun (a, b, back) -> (a, { b with Motion.velocity = Vec.axpy (Rat.neg back) b.Motion.centre b.velocity }))
    (Gen.triple (moving (Gen.return Vec.zero)) (moving (triples 5)) (Gen.oneofl [ ratio 1 2; Rat.one; ratio 3 2 ]))

(* They touch now, aligned or along a line, and then turn and slide. *)
let touching =
  Gen.map2
    (fun pair (sa, sb, va, vb) ->
       match pair with
       | None -> None
       | Some ((a : Placed.t), (b : Placed.t)) ->
         let motion (p : Placed.t) spin velocity = body p.solid p.at ~turned:p.turned ~spin ~velocity in
         Some (motion a sa va, motion b sb vb))
    touching_pair
    (Gen.quad spin spin (Gen.oneofl [ Vec.zero; v 1 0 0; v 0 1 1 ]) (Gen.oneofl [ Vec.zero; v 0 0 1; v (-1) 0 0 ]))

let some =
  let cube at = body (Lazy.force small_cube) at in
  Gen.map (function Some pair -> pair | None -> (cube Vec.zero, cube (v 9 0 0))) touching

let show_motion (m : Motion.t) =
  Printf.sprintf "%d vertices, turned %s, arm %s, centre %s, velocity %s, spin %s, since %s"
    (Array.length m.solid.vertices) (Quaternion.to_string m.turned) (Vec.to_string m.arm)
    (Vec.to_string m.centre) (Vec.to_string m.velocity) (Vec.to_string m.spin) (Rat.to_string m.since)

let show (a, b) = show_motion a ^ "\n" ^ show_motion b

let property ?(count = 60) name gen f =
  let run (a, b) =
    QCheck2.assume (Sweep.relation a b Rat.zero <> Obstacle.Interpenetrating);
    f a b (Sweep.first_penetration a b ~from:Rat.zero ~until:Rat.one)
  in
  QCheck2.Test.make ~name ~count ~print:show gen run

let tiny = Rat.make Z.one (Z.shift_left Z.one 30)

(* Disjoint interiors up to the instant and, unless they pass through each other in no time, not after it. *)
let relation a b found =
  let disjoint t = Sweep.relation a b t <> Obstacle.Interpenetrating in
  let upto = match found with Sweep.Never -> Rat.one | At t -> fst (Algebraic.enclose t ~width:tiny) in
  let steps = List.init 9 (fun i -> Rat.mul (ratio i 8) (Rat.max Rat.zero upto)) in
  List.for_all disjoint steps
  &&
  match found with
  | Never -> true
  | At t ->
    let after = Rat.add tiny (snd (Algebraic.enclose t ~width:tiny)) in
    not (disjoint after)

let swapped a b found = equal found (Sweep.first_penetration b a ~from:Rat.zero ~until:Rat.one)

let moved by to_ (m : Motion.t) =
  let turn = Quaternion.apply by in
  {
    m with
    turned = Quaternion.mul by m.turned;
    arm = turn m.arm;
    centre = Vec.add to_ (turn m.centre);
    velocity = turn m.velocity;
    spin = turn m.spin;
  }

let whole_world a b found =
  let by = quaternion (3, 1, -2, 5) and to_ = Vec.make (ratio 7 3) (Rat.of_int (-11)) (ratio 1 9) in
  equal found (Sweep.first_penetration (moved by to_ a) (moved by to_ b) ~from:Rat.zero ~until:Rat.one)

(* The same from a third of the time on, told from then on. *)
let later a b found =
  let d = ratio 1 3 in
  let shift (m : Motion.t) = { m with centre = Vec.axpy d m.velocity m.centre; since = Rat.add d m.since } in
  let found' = Sweep.first_penetration a b ~from:d ~until:Rat.one in
  let shifted = Sweep.first_penetration (shift a) (shift b) ~from:Rat.zero ~until:(Rat.sub Rat.one d) in
  let back = match found' with Sweep.Never -> Sweep.Never | At t -> At (Algebraic.add_rat (Rat.neg d) t) in
  equal back shifted
  && match found with Sweep.At t when Algebraic.compare_rat t d < 0 -> true | Never | At _ -> equal found found'

(* Stopped before and after the instant. *)
let parts a b found =
  let ask until = Sweep.first_penetration a b ~from:Rat.zero ~until in
  match found with
  | Sweep.Never -> equal Sweep.Never (ask (ratio 1 2))
  | At t ->
    let low, high = Algebraic.enclose t ~width:tiny in
    (Rat.sign low <= 0 || equal Sweep.Never (ask low))
    && equal found (ask (Rat.add high tiny))
    && (Rat.sign low <= 0 || equal found (Sweep.first_penetration a b ~from:low ~until:Rat.one))

let both name f = [ property name meeting f; property (name ^ ", touching now") some f ]

let hulls = lazy (solid_of (Data.shape "../../data/geometry/poly50.txt"))

let hulls_of_50 =
  let gen =
    Gen.map2
      (fun (t, u, s) (w, c) ->
         let hull = Lazy.force hulls in
         let centre = Vec.scale (Rat.of_int 300) c in
         (body hull Vec.zero ~turned:t ~spin:s, body hull centre ~turned:u ~spin:w ~velocity:(Vec.neg centre)))
      (Gen.triple any_turn any_turn spin)
      (Gen.pair spin (Gen.map (fun (x, y) -> v 7 x y) Gen.(pair (-5 -- 5) (-5 -- 5))))
  in
  property ~count:5 "hulls of 50 faces" gen (fun a b found -> relation a b found && swapped a b found)

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("first penetration",
   [ ( "by hand",
       [ case "resting and sliding" resting; case "on the tip" on_the_tip; case "a rod and a wall" rod_and_wall;
         case "grazes" grazes ] );
     ( "without turning",
       [ case "aligned cubes" (casts "cube.txt" "pairs_deg.txt" 1);
         case "cubes" (casts "cube.txt" "pairs_cube.txt" 10);
         case "hulls of 50 faces" (casts "poly50.txt" "pairs_poly.txt" 40) ]
       @ Scc_test_support.Property.cases
         [ cast "casts" Solids.aimed; cast "resting bodies" Solids.resting; cast "scenes" Solids.scene ] );
     ( "turning",
       Scc_test_support.Property.cases
         (List.concat
            [ both "relations" relation; both "swap" swapped; both "the whole world moved" whole_world;
              both "later" later; both "parts" parts; [ hulls_of_50 ] ]) ) ])
