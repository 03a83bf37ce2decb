open Scc_exact
open Scc_rigid
open Bodies

let show_mat (m : Mat.t) = String.concat " " (List.map Vec.to_string [ m.r0; m.r1; m.r2 ])
let check_mat what a b = Alcotest.(check string) what (show_mat a) (show_mat b)
let check_vec what a b = Alcotest.(check string) what (Vec.to_string a) (Vec.to_string b)

let box id x y z = Scc_test_data.Test_data.solid ~id (Solids.box x y z) Mat.identity
let part solid turned at mass = { Mass.body = { Placed.solid; turned; at }; mass = Rat.of_int mass }

(* Half sides 1, 2, 3: m/3 (4 + 9) and so on. *)
let of_box () =
  let m = Mass.of_part (part (box 0 1 2 3) Quaternion.identity (v 5 6 7) 6) in
  check_vec "centre" (v 5 6 7) m.centre;
  check_mat "about the centre" (Mat.diagonal (v 26 20 10)) m.inertia;
  let quarter = quaternion (1, 0, 0, 1) in
  let m = Mass.of_part (part (box 0 1 2 3) quarter Vec.zero 6) in
  check_mat "a quarter turn about z" (Mat.diagonal (v 20 26 10)) m.inertia

let cut () =
  let turned = quaternion (3, 1, -2, 1) in
  let at p = Quaternion.apply turned p in
  let whole = Mass.of_part (part (box 0 3 2 1) turned Vec.zero 12) in
  let halves =
    Mass.of_parts [ part (box 1 1 2 1) turned (at (v (-2) 0 0)) 4; part (box 2 2 2 1) turned (at (v 1 0 0)) 8 ]
  in
  Alcotest.(check string) "mass" (Rat.to_string whole.mass) (Rat.to_string halves.mass);
  check_vec "centre" whole.centre halves.centre;
  check_mat "inertia" whole.inertia halves.inertia

let property name ~count gen f = QCheck2.Test.make ~name ~count ~print:show gen f

(* R I R^T against the integrals over the turned solid. *)
let turned (b : Placed.t) =
  let m = Mass.of_part { body = b; mass = Rat.of_int 7 } and s = Placed.fixed_solid b in
  Vec.equal m.centre (Vec.add b.at s.centroid)
  && Mat.equal m.inertia (Mat.scale (Rat.div (Rat.of_int 7) s.volume) s.inertia)

let positive (b : Placed.t) =
  let m = Mass.of_part { body = b; mass = Rat.one } in
  List.for_all (fun u -> Rat.sign (Vec.dot u (Mat.apply m.inertia u)) > 0) [ v 1 0 0; v 1 1 1; v 2 (-3) 1 ]
  && Mat.equal m.inertia (Mat.transpose m.inertia)
  && Vec.equal (v 1 2 3) (Mat.apply m.inertia (Mass.turn_rate m (v 1 2 3)))

let joined (a, b, c) =
  let m = List.map (fun body -> Mass.of_part { Mass.body; mass = Rat.of_int (1 + body.Placed.solid.id) }) in
  let all = Mass.join (m [ a; b; c ]) and nested = Mass.join (Mass.join (m [ a; b ]) :: m [ c ]) in
  Rat.equal all.mass nested.mass && Vec.equal all.centre nested.centre && Mat.equal all.inertia nested.inertia

(* The kinetic energy of parts that move as one is that of the whole, and so is the angular momentum. *)
let moving (a, b, c) =
  let parts = List.map (fun body -> Mass.of_part { Mass.body; mass = Rat.of_int 2 }) [ a; b; c ] in
  let whole = Mass.join parts in
  let velocity = v 1 (-2) 3 and spin = v 2 1 (-1) and about = v 7 0 1 in
  let at (p : Mass.t) = Vec.add velocity (Vec.cross spin (Vec.sub p.centre whole.centre)) in
  let energies = List.map (fun p -> Mass.energy p ~velocity:(at p) ~spin) parts in
  let turning = List.map (fun p -> Mass.angular_momentum p ~velocity:(at p) ~spin ~about) parts in
  Rat.equal (Mass.energy whole ~velocity ~spin) (List.fold_left Rat.add Rat.zero energies)
  && Vec.equal
    (Mass.angular_momentum whole ~velocity ~spin ~about)
    (List.fold_left Vec.add Vec.zero turning)

let show3 (a, b, c) = String.concat "; " (List.map show [ a; b; c ])

let suite =
  let body = placed any_turn halves in
  let three name f = QCheck2.Test.make ~name ~count:50 ~print:show3 (Gen.triple body body body) f in
  ("mass",
   [ ( "known",
       [ Alcotest.test_case "a box" `Quick of_box; Alcotest.test_case "a box cut into two boxes" `Quick cut ] );
     ( "properties",
       Scc_test_support.Property.cases
         [ property "the integrals over the turned solid" ~count:100 body turned;
           property "symmetric and positive" ~count:100 body positive;
           three "the whole does not depend on the bracketing" joined;
           three "parts that move as one" moving ] ) ])
