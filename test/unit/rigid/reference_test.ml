(* Casts of turning bodies against subdivision of time (test/references/naive/turning.mli), a share of
   test/references/turning/missed.ml; and the subdivision itself. *)

open Scc_exact
open Scc_rigid
open Scc_turning
module Naive = Scc_naive.Naive
module Turning = Scc_naive.Turning
module Rng = Scc_long.Rng

let cast : Turning_check.cast = fun a b -> Cast.first_time_of_contact a b

let kinds : (Turning_cases.kind * Turning_cases.shape array * int) list =
  [ (Chance, Turning_cases.small, 300); (Aligned, [| Turning_cases.cube |], 100);
    (Aligned, Turning_cases.small, 50); (Peak, Turning_cases.small, 100); (Grazing, Turning_cases.small, 50) ]

let tally ?(share = 1) cast =
  let t = Turning_check.tally () in
  List.iter
    (fun (kind, shapes, count) -> Turning_check.run cast t ~seed:2 kind shapes ~from:0 ~count:(count / share))
    kinds;
  t

let agrees ?share cast () =
  let t = tally ?share cast in
  List.iter print_endline t.complaints;
  Alcotest.(check bool) "nothing missed, spurious or at another time" true (Turning_check.right t);
  Alcotest.(check bool) "many contacts" true (3 * t.hits > t.checked);
  Alcotest.(check bool) "and many without" true (3 * t.hits < 2 * t.checked)

(* The subdivision sees casts that are a little wrong. *)
let broken () =
  let right = tally ~share:2 cast in
  let next by t grid = Rat.add t (Rat.make (Z.of_int by) (Z.shift_left Z.one grid)) in
  let changed f = tally ~share:2 (fun a b ~span ~grid -> f (cast a b ~span ~grid) grid) in
  let found (t : Turning_check.tally) = t.missed + t.spurious + t.wrong_times in
  let silent = changed (fun _ _ -> Cast.Never) in
  Alcotest.(check int) "contacts left out" right.hits silent.missed;
  let shifted by = changed (fun o grid -> match o with At t -> At (next by t grid) | o -> o) in
  let at = changed (fun o _ -> match o with At _ -> Never | o -> o) in
  let at = found at in
  Alcotest.(check bool) "some" true (at > 50);
  Alcotest.(check bool) "a cell late" true (found (shifted 1) >= at - 2);
  Alcotest.(check bool) "a cell early" true (found (shifted (-1)) >= at - 2);
  let eager = changed (fun o _ -> match o with Never -> At Rat.zero | o -> o) in
  Alcotest.(check bool) "contacts made up" true (eager.spurious > 50);
  let inside = changed (fun o _ -> match o with Never -> Inside | o -> o) in
  Alcotest.(check bool) "inside made up" true (inside.spurious > 50)

(* {1 The subdivision against samples}

   With matrices of quaternions instead of polynomials, and [Naive.relation]. *)

let placed (b : Turning.body) t =
  let w, x, y, z = b.turned in
  let matrix q = Option.get (Mat.of_quaternion q) in
  let u = Vec.scale (Rat.mul (Rat.make Z.one (Z.of_int 2)) (Rat.add b.since t)) b.spin in
  let turn = matrix (Rat.one, u.x, u.y, u.z) in
  Naive.move
    (Mat.mul turn (matrix (w, x, y, z)))
    (Vec.add (Vec.axpy t b.velocity b.centre) (Mat.apply turn b.arm))
    b.solid

let sampled () =
  let inside = ref 0 and outside = ref 0 in
  let case kind i =
    let g = Rng.make [ 77; i ] in
    let shape_a = Rng.choose g Turning_cases.small in
    let shape_b = Rng.choose g Turning_cases.small in
    let c = Turning_cases.make kind shape_a shape_b g in
    let found = Turning.first c.a c.b ~span:c.span in
    let meets t = Naive.relation (placed c.a t) (placed c.b t) = Interpenetrating in
    let sample k =
      let t = Rat.mul c.span (Rat.make (Z.of_int k) (Z.of_int 9)) in
      let meets = meets t in
      incr (if meets then inside else outside);
      let what = "the test at an instant: " ^ Turning_cases.show c in
      Alcotest.(check bool) what meets (Turning.interpenetrate c.a c.b t);
      let doubtful = List.exists (fun (lo, hi) -> Rat.compare lo t <= 0 && Rat.compare t hi <= 0) found.doubts in
      let before =
        match found.first with Never -> true | Inside -> false | Within (lo, _) -> Rat.compare t lo <= 0
      in
      if before && not doubtful then
        Alcotest.(check bool) ("nothing before: " ^ Turning_cases.show c) false meets
    in
    Alcotest.(check bool) "not given up" false found.given_up;
    List.iter sample [ 0; 2; 5; 7; 9 ];
    match found.first with
    | Never -> ()
    | Inside -> Alcotest.(check bool) "inside at 0" true (meets Rat.zero)
    | Within (_, hi) -> Alcotest.(check bool) "inside where it says so" true (meets hi)
  in
  List.iter (fun kind -> List.iter (case kind) (List.init 20 Fun.id)) [ Turning_cases.Chance; Aligned; Peak ];
  Alcotest.(check bool) "both kinds of samples" true (!inside > 40 && !outside > 40)

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("turning bodies against subdivision of time",
   [ ( "casts",
       [ case "the cast" (agrees cast); case "the exact sweep" (agrees ~share:3 Turning_check.by_sweep);
         case "wrong casts are seen" broken ] );
     ("the subdivision", [ case "against samples" sampled ]) ])
