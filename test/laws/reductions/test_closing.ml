(* What goes on for ever and closes all the same: times after all that is asked about, and bodies that drift apart. *)

open Scc_space
open Crowds
open Compared

(* A ball between two walls that a law slows down at time 20, once: after that, and not before, its states come back. It
   is from 3 to 7 and back in 8 steps; at time 20 it has been half way once more. *)
let laws_of_time () =
  let text =
    shapes
    ^ {|
fixed west = Cube at translate (0,0,0)
fixed east = Cube at translate (10,0,0)
process p = Cube mass 1 velocity (1,0,0) at translate (4,0,0) [Shy]
motion p = (if time = 20 then vx / 2 else vx, 0, 0)
check goes_on : AG EF touching(p, east)
check slows   : eventually speed2(p) = 1/4
check stays   : AG (speed2(p) < 1 => AG speed2(p) < 1)
check early   : AG (time < 20 => speed2(p) = 1)
|}
  in
  let verdicts, stats = verdicts_and_stats [ Reduction.Time; Jump ] text in
  let holds = "holds (exhaustive)" in
  Alcotest.(check (list string)) "proofs" [ holds; holds; holds; holds ] verdicts;
  Alcotest.(check bool) "all is explored" true stats.complete;
  let _, stats = verdicts_and_stats [ Jump ] text in
  Alcotest.(check bool) "without, it has no end" false stats.complete

let means_of_time () =
  let values reductions =
    let text =
      shapes
      ^ {|
behaviour Lot on Cube = omega(dock, {left, right}) rate 1. nil
process d = p : Cube mass 1 [Lot] <dock, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Lot]
check now   : E = ? [ time at 3 ]
check twice : E = ? [ 2 * time - 1 at 5/2 ]
|}
    in
    fst (verdicts_and_stats reductions text)
  in
  List.iter
    (fun reductions -> Alcotest.(check (list string)) "the time itself" [ "3"; "4" ] (values reductions))
    [ [ Reduction.Jump ]; Reduction.all ]

let () =
  let quick name f = Alcotest.test_case name `Quick f in
  Alcotest.run "closing"
    [
      ( "time",
        [
          quick "laws that look at time up to a constant" laws_of_time;
          quick "a mean sees all of the time" means_of_time;
        ] );
    ]
