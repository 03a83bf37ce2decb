(* Runs of formulas over zones whose ends were worked out by hand: where they lead, and when. *)

open Scc_explain
open Scc_verify
open Scc_zones

let report text =
  let l = By_hand.load text in
  let u = match l.uncertain with Some u -> u | None -> Scc_symbolic.Start.known l.model l.declared in
  match Zone_check.run Setup.default l.semantics u ~declared:l.declared ~exactly:false ~premises:[] l.checks with
  | Ok report -> report.outcomes
  | Error _ -> Alcotest.fail "the start is not well-formed"

let ending (w : Witness.t) =
  let after = " after " ^ string_of_int (List.length w.steps) in
  (match w.finish with
   | At_state -> "there"
   | During { open_piece; _ } -> if open_piece then "right after" else "during"
   | Rests { puts_off } -> if puts_off = None then "rests" else "rests, putting off"
   | Stops -> "stops"
   | Repeats { cycle; _ } -> "repeats from " ^ string_of_int cycle
   | Passes _ -> "passes"
   | Goes_on { cycle } -> "goes on like " ^ string_of_int cycle)
  ^ after

let shown (o : Verdict.outcome) =
  let of_run = function None -> "no run" | Some w -> ending w in
  let text =
    match o.verdict with
    | Holds { witness; _ } -> "holds: " ^ of_run witness
    | Violated { witness } -> "violated: " ^ of_run witness
    | Measured _ | Depends _ -> "measured"
    | Undecided _ -> "undecided"
  in
  (o.check.name, text)

let case name text expected =
  let test () = Alcotest.(check (list (pair string string))) name expected (List.map shown (report text)) in
  Alcotest.test_case name `Quick test

let dimer =
  {|split_step any
behaviour L on Cube = omega(b, {right}). nil
behaviour R on Cube = omega(b, {left}). nil
process p = Cube mass 1 at translate (0,20,0) [L]
process q = Cube mass 1 at translate (2,20,0) [R]
bond <b, {p.right, q.left}>
|}

let thrown =
  {|split_step any
behaviour L on Cube = omega(b, {right}) push(1). nil
behaviour R on Cube = omega(b, {left}). nil
process p = Cube mass 1 at translate (0,20,0) [L]
process q = Cube mass 1 at translate (2,20,0) [R]
process r = Cube mass 1 at translate (0,0,0) [L]
process s = Cube mass 1 at translate (2,0,0) [R]
bond <b, {p.right, q.left}>
bond <b, {r.right, s.left}>
|}

let cases =
  [
    case "a bond that holds for ever" (dimer ^ "check parts : eventually not bound(p, q)")
      [ ("parts", "violated: rests, putting off after 0") ];
    (* after 1/16, and before 1/8: from 1/8 to 1/4 it must not be *)
    case "a split in between"
      ({|split_step any
behaviour L on Cube = omega(b, {right}). nil
behaviour R on Cube = omega(b, {left}). nil
process p = Cube mass 1 velocity (1,0,0) at translate (0,20,0) [L]
process q = Cube mass 1 velocity (1,0,0) at translate (2,20,0) [R]
bond <b, {p.right, q.left}>
let far = x(p) > 1/16
check before : E[(bound(p, q) or far) and (x(p) < 1/8 or x(p) > 1/4) U not bound(p, q) and far]
check again : E[(bound(p, q) or far) and (x(p) > 1/4 or x(p) < 1/8) U not bound(p, q) and far]
|})
      [ ("before", "holds: there after 2"); ("again", "holds: there after 2") ];
    (* it bounces at 2, 6, 10, ... *)
    case "a ball between walls"
      (dimer
       ^ {|process ball = Cube mass 1 velocity (1,0,0) [nil]
fixed west = Cube at translate (-4,0,0) [nil]
fixed east = Cube at translate (4,0,0) [nil]
check parts : eventually not bound(p, q)
check soon  : eventually not bound(p, q) within 5
check until : A[x(ball) <= 1 U x(ball) > 1 and not bound(p, q)]
check apart : A[x(ball) <= 1 U x(ball) > 1]
check first : E[(x(ball) < 1/2 or x(ball) > 1 or not bound(p, q)) U event bounce(ball, east)]
|})
      [
        ("parts", "violated: repeats from 1 after 5");
        ("soon", "violated: passes after 2");
        ("until", "violated: during after 0");
        ("apart", "violated: right after after 0");
        ("first", "holds: there after 3");
      ];
    (* the ball is at 2 at the time 2, when it may bounce or the bond be released, and at the beginning at 0 *)
    case "what is next, at any time"
      (dimer
       ^ {|process ball = Cube mass 1 velocity (1,0,0) [nil]
fixed west = Cube at translate (-4,0,0) [nil]
fixed east = Cube at translate (4,0,0) [nil]
let parts = event weak(b, p, q)
check some_time : EX (parts and x(ball) > 1 and x(ball) < 3/2)
check at_once   : EX (parts and x(ball) = 0)
check at_bounce : EX (parts and x(ball) = 2)
check bounces   : EX event bounce(ball, east)
check all       : AX event bounce(ball, east)
check too_late  : EX (parts and x(ball) < 0)
let there = x(ball) > 1 and vx(ball) > 0 and bound(p, q)
check late      : AG (there => EX (parts and x(ball) < 3/2))
check in_time   : AG (there and x(ball) < 3/2 => EX (parts and x(ball) < 3/2))
|})
      [
        ("some_time", "holds: there after 2");
        ("at_once", "holds: there after 1");
        ("at_bounce", "holds: there after 2");
        ("bounces", "holds: there after 2");
        ("all", "violated: there after 1");
        ("too_late", "violated: no run");
        ("late", "violated: during after 0");
        ("in_time", "holds: no run");
      ];
    (* the bond may be released at 0, 1 and 2 as well, and is not *)
    case "what is next, on a grid"
      ({|split_step 1
behaviour L on Cube = omega(b, {right}). nil
behaviour R on Cube = omega(b, {left}). nil
process p = Cube mass 1 at translate (0,20,0) [L]
process q = Cube mass 1 at translate (2,20,0) [R]
bond <b, {p.right, q.left}>
process ball = Cube mass 1 velocity (1,0,0) [nil]
fixed west = Cube at translate (-4,0,0) [nil]
fixed east = Cube at translate (4,0,0) [nil]
check bounces : EX event bounce(ball, east)
check second  : EX (event weak and EX event bounce(ball, east))
|})
      [ ("bounces", "holds: there after 3"); ("second", "holds: there after 3") ];
    (* before p and q part, r and s have to *)
    case "two bonds"
      (dimer
       ^ {|process r = Cube mass 1 at translate (0,30,0) [L]
process s = Cube mass 1 at translate (2,30,0) [R]
bond <b, {r.right, s.left}>
process ball = Cube mass 1 velocity (1,0,0) [nil]
check late : E[(x(ball) < 1/2 or x(ball) > 1 or not bound(r, s)) U (event weak(b, p, q) and x(ball) > 1)]
|})
      [ ("late", "holds: there after 3") ];
    (* p and q fly apart for ever while r and s go to and fro *)
    case "two bodies that drift"
      (thrown
       ^ {|fixed west = Cube at translate (-4,0,0) [nil]
fixed east = Cube at translate (6,0,0) [nil]
check goes : not EF EG (not bound(p, q) and AF event bounce(s, east))
|})
      [ ("goes", "violated: goes on like 2 after 7") ];
  ]
