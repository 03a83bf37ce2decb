(* Slices against whole networks: the same verdicts, and runs that can be lifted. *)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_state_space
open Scc_explain
open Scc_verify
open Scc_test_models

let standard = Scc_engine.Standard.of_model

(* {1 The same verdicts, and runs of the whole} *)

let generous n = { Setup.default with bounds = { Bounds.default with states = Given n } }

let check options m initial formula =
  let check = { Property.name = "c"; span = Scc_base.Span.none; text = ""; asked = Whether; formula } in
  match (Check.run options (standard m) ~initial [ check ]).outcomes with
  | [ o ] -> o.verdict
  | _ -> failwith "one outcome"

let decided : Verdict.t -> bool option = function
  | Holds { bounds = []; _ } -> Some true
  | Violated _ -> Some false
  | Holds _ | Measured _ | Depends _ | Undecided _ -> None

let witness : Verdict.t -> Witness.t option = function
  | Holds { witness; _ } | Violated { witness } | Measured { witness; _ } -> witness
  | Depends _ | Undecided _ -> None

let facts m formula (w : Witness.t) =
  let arrived =
    match List.rev w.steps with
    | [] -> fun _ -> false
    | [ only ] -> Event.matches ~source:w.initial only.transition.label
    | last :: before :: _ -> Event.matches ~source:before.transition.target last.transition.label
  in
  let extent, offset =
    match w.finish with During { offset; _ } -> (Timeline.Forever, offset) | _ -> (Instant, Algebraic.zero)
  in
  List.concat_map (Facts.at ~arrived (standard m) w.last extent offset) (Formula.predicates formula)

(* Why the lifted run is not one of the whole that ends as the run of the slice does. *)
let fault m initial formula (w : Witness.t) (lifted : Witness.t) =
  let targets = List.map (fun (s : Witness.step) -> s.transition.target) lifted.steps in
  let in_time time (s : Witness.step) =
    Option.bind time (fun t ->
        let t = Rat.add t (Transition.duration s.transition) in
        if Rat.equal t s.time then Some t else None)
  in
  match Scc_test_networks.Reach.follow (standard m) initial (Witness.choices lifted) with
  | Error _ -> Some "it does not replay"
  | Ok transitions ->
    if not (List.for_all2 (fun (t : Transition.t) s -> State.equal t.target s) transitions targets) then
      Some "it leads elsewhere"
    else if
      not
        (List.for_all2
           (fun (t : Transition.t) (s : Witness.step) ->
              Transition.equal_label t.label s.transition.label && t.rules = s.transition.rules)
           transitions lifted.steps)
    then Some "it has other labels"
    else if List.fold_left in_time (Some Rat.zero) lifted.steps = None then Some "wrong times"
    else if not (Algebraic.equal (Witness.instant w) (Witness.instant lifted)) then Some "another instant"
    else if
      not (State.equal lifted.last (match List.rev targets with [] -> initial | last :: _ -> last))
    then Some "another last state"
    else
      let ends = facts m formula w and lifted_ends = facts m formula lifted in
      if List.equal String.equal ends lifted_ends && w.facts = lifted.facts then None
      else Some ("other facts: " ^ String.concat "; " (ends @ ("and" :: lifted_ends)))

let lasts_beyond (w : Witness.t) m =
  match (w.finish, Network.successors (standard m) w.last) with
  | During { choice = Some k; offset; from; _ }, Ok transitions -> (
      match (List.nth transitions k).label with
      | Time d -> Algebraic.compare_rat offset d < 0 && Algebraic.compare_rat from Rat.zero >= 0
      | _ -> false)
  | During { choice = None; _ }, Ok transitions -> transitions = []
  | _ -> true

(* How many slices were made, decided on both sides, and lifted: nothing compared would be worth nothing. *)
type tally = { mutable made : int; mutable compared : int; mutable lifted : int; mutable longer : int }

let agrees tally (q : Clusters.question) =
  let m, initial = Clusters.assemble q.clusters in
  match Slice.make (standard m) ~initial [ q.formula ] with
  | None -> true
  | Some slice -> (
      tally.made <- tally.made + 1;
      let of_slice = check (generous 1500) m slice q.formula in
      (match witness of_slice with
       | None -> ()
       | Some w -> (
           let lifted = Lift.timed (standard m) ~initial w in
           tally.lifted <- tally.lifted + 1;
           if List.compare_lengths lifted.steps w.steps > 0 then tally.longer <- tally.longer + 1;
           if not (lasts_beyond lifted m) then QCheck2.Test.fail_report "the instant is not in its transition";
           match fault m initial q.formula w lifted with
           | None -> ()
           | Some why -> QCheck2.Test.fail_report why));
      match (decided of_slice, decided (check (generous 1500) m initial q.formula)) with
      | Some a, Some b ->
        tally.compared <- tally.compared + 1;
        if a = b then true
        else QCheck2.Test.fail_report (Printf.sprintf "slice: %b, whole: %b" a b)
      | _, _ -> true)
let tally = { made = 0; compared = 0; lifted = 0; longer = 0 }

let random =
  QCheck2.Test.make ~name:"Fragments: clusters" ~count:450 ~print:Clusters.print Clusters.question (agrees tally)

let counts () =
  Printf.printf "%d slices, %d verdicts compared, %d runs lifted, %d of them longer\n" tally.made tally.compared
    tally.lifted tally.longer;
  let some what expected n =
    if n < expected then Alcotest.failf "only %d %s" n what
  in
  some "slices" 150 tally.made;
  some "verdicts compared" 150 tally.compared;
  some "runs lifted" 75 tally.lifted;
  some "runs that got longer" 5 tally.longer

(* {1 By hand} *)

let cube =
  {|
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

let load text =
  let e = Load.exactly (Load.text (cube ^ text)) in
  match Network.initial (standard e.model) e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial -> (e.model, initial, List.map (fun (c : Property.check) -> c.formula) e.checks)

let all_kept = [ "(no slice)" ]

let left_out text =
  let m, initial, formulas = load text in
  match Slice.make (standard m) ~initial formulas with
  | None -> all_kept
  | Some slice -> Slice.left_out m ~initial slice

let is what expected text = Alcotest.(check (list string)) what expected (left_out text)

let dimers n =
  Printf.sprintf
    {|
behaviour Left  on Cube = omega(bond, {right}). nil
behaviour Right on Cube = omega(bond, {left}). nil
for i in 1..%d {
  process d[i] = p[i] : Cube mass 1 at translate (0, 4*i, 0) [Left] <bond, {p[i].right, q[i].left}>
                 q[i] : Cube mass 1 at translate (2, 4*i, 0) [Right]
}
|}
    n

let one_of_many () =
  is "three dimers" [ "p[1]"; "q[1]"; "p[3]"; "q[3]" ] (dimers 3 ^ "check a : possibly not bound(p[2], q[2])");
  is "two formulas" [ "p[1]"; "q[1]" ]
    (dimers 3 ^ "check a : possibly not bound(p[2], q[2])\ncheck b : always size(p[3]) = 2 within 3");
  is "all of them" all_kept (dimers 1 ^ "check a : possibly not bound(p[1], q[1])");
  let m, initial, formulas = load (dimers 2000 ^ "check a : always bound(p[7], q[7])") in
  match Slice.make (standard m) ~initial formulas with
  | None -> Alcotest.fail "no slice"
  | Some slice -> (
      Alcotest.(check int) "one is left" 1 (Array.length slice.processes);
      match witness (check Setup.default m slice (List.hd formulas)) with
      | None -> Alcotest.fail "no witness"
      | Some w ->
        let lifted = Lift.timed (standard m) ~initial w in
        Alcotest.(check (option string)) "lifted" None (fault m initial (List.hd formulas) w lifted))

let fragment () =
  let outside what check = is what all_kept (dimers 3 ^ "check a : " ^ check) in
  outside "AF" "eventually not bound(p[2], q[2])";
  outside "EG" "EG bound(p[2], q[2])";
  outside "X" "EX bound(p[2], q[2])";
  outside "U" "E[ bound(p[2], q[2]) U not bound(p[2], q[2]) ]";
  outside "nested" "always possibly not bound(p[2], q[2])";
  outside "from later on" "EF[1,2] not bound(p[2], q[2])";
  outside "global" "possibly bonds(bond) = 0 and bound(p[2], q[2])";
  outside "any event" "possibly event weak(bond) and bound(p[2], q[2])";
  outside "quiescent" "possibly quiescent and bound(p[2], q[2])";
  outside "no leaf" "possibly time = 2";
  outside "an event that must not be" "possibly not event weak(bond, p[2]) and not bound(p[2], q[2])";
  outside "nor always be" "always event weak(bond, p[2]) or bound(p[2], q[2])";
  outside "nor be counted" "possibly (if event weak(bond, p[2]) then 1 else 0) = size(p[2])";
  let inside what check = is what [ "p[1]"; "q[1]"; "p[3]"; "q[3]" ] (dimers 3 ^ "check a : " ^ check) in
  inside "an event" "possibly event weak(bond, p[2])";
  inside "never an event" "always not event weak(bond, p[2])";
  inside "time" "possibly time = 2 and not bound(p[2], q[2])";
  inside "connected" "(possibly not bound(p[2], q[2])) and not (possibly x(p[2]) > 4 within 3)";
  inside "now" "bound(p[2], q[2]) and possibly not bound(p[2], q[2])"

let still = "process s = Cube mass 1 [nil]\n"

let in_motion () =
  let bullet = still ^ "process b = Cube mass 1 velocity (1,0,0) at translate (-7,0,0) [nil]\n" in
  is "it hits at 5, too late" [ "b" ] (bullet ^ "check a : always x(s) = 0 within 49/10");
  is "just in time" all_kept (bullet ^ "check a : always x(s) = 0 within 5");
  is "some time" all_kept (bullet ^ "check a : always x(s) = 0");
  is "away" [ "b" ]
    (still
     ^ "process b = Cube mass 1 velocity (-1,0,0) at translate (-7,0,0) [nil]\ncheck a : always x(s) = 0");
  is "past" [ "b" ]
    (still
     ^ "process b = Cube mass 1 velocity (1,0,0) at translate (-7,2,0) [nil]\ncheck a : always x(s) = 0");
  is "touching at rest" [ "b" ]
    (still ^ "process b = Cube mass 1 at translate (2,0,0) [nil]\ncheck a : always x(s) = 0");
  is "equal velocities" [ "b" ]
    ("process s = Cube mass 1 velocity (2,1,0) [nil]\n"
     ^ "process b = Cube mass 1 velocity (2,1,0) at translate (2,0,0) [nil]\ncheck a : always vx(s) = 2")

let through_others () =
  (* b hits the first of two at 1; which then may hit s, 2 further, at 3 *)
  let three =
    still
    ^ {|
process c = Cube mass 1 at translate (-4,0,0) [nil]
process b = Cube mass 1 velocity (1,0,0) at translate (-7,0,0) [nil]
|}
  in
  is "it gets there" all_kept (three ^ "check a : always x(s) = 0 within 3");
  is "but not in a short time" [ "c"; "b" ] (three ^ "check a : always x(s) = 0 within 3/2");
  let turned =
    still
    ^ {|
process c = Cube mass 1 at translate (-6,-6,0) [nil]
process b = Cube mass 9 velocity (1,1,0) at translate (-10,-9,0) [nil]
|}
  in
  is "not by its line" [ "c"; "b" ] (turned ^ "check a : always x(s) = 0 within 1");
  is "but perhaps after a collision" all_kept (turned ^ "check a : always x(s) = 0 within 9/2");
  (* binding to a heavy one gives a light one no more than the energy allows *)
  let sideways =
    still
    ^ {|
process c = Cube mass 1 at translate (-6,-6,0) [nil]
process b = Cube mass 9 velocity (1,0,0) at translate (-9,-6,0) [nil]
|}
  in
  is "a light one may be three times as fast" all_kept (sideways ^ "check a : always x(s) = 0 within 7/5");
  is "no faster" [ "c"; "b" ] (sideways ^ "check a : always x(s) = 0 within 13/10");
  let head_on =
    still
    ^ {|
process c = Cube mass 1 velocity (-1,0,0) at translate (-6,-6,0) [nil]
process b = Cube mass 1 velocity (1,0,0) at translate (-9,-6,0) [nil]
|}
  in
  is "one may get the energy of both" all_kept (head_on ^ "check a : always x(s) = 0 within 29/10");
  is "no more" [ "c"; "b" ] (head_on ^ "check a : always x(s) = 0 within 28/10");
  is "with all the time there is, anywhere" all_kept (head_on ^ "check a : always x(s) = 0");
  is "one that is met on the way may be light" all_kept
    (still
     ^ {|
process d = Cube mass 1 at translate (-6,-3,0) [nil]
process c = Cube mass 9 at translate (-6,-6,0) [nil]
process b = Cube mass 9 velocity (1,0,0) at translate (-9,-6,0) [nil]
check a : always x(s) = 0 within 7/5
|})

let walls () =
  let scene =
    {|
fixed floor = Cube scaled (100,1,100) at translate (0,-1,0)
process s = Cube mass 1 velocity (0,-1,0) at translate (0,2,0) [nil]
process t = Cube mass 1 velocity (0,-1,0) at translate (30,2,0) [nil]
process u = Cube mass 1 at translate (60,1,0) [nil]
|}
  in
  is "joins nothing together, but is kept" [ "t"; "u" ] (scene ^ "check a : possibly y(s) > 4 within 10");
  is "one at rest on it does not need it" [ "floor"; "s"; "t" ] (scene ^ "check a : possibly y(u) > 4 within 10");
  is "it is asked for" [ "s"; "t" ] (scene ^ "check a : always touching(u, floor) within 10");
  is "all that may bounce off it" [ "u" ] (scene ^ "check a : always not event bounce(floor) within 10");
  is "a sticky one" [ "u" ]
    ({|
behaviour Stick on Cube = <grip, {top}>. nil
fixed floor = Cube scaled (100,1,100) at translate (0,-1,0) [eps(3). Stick]
process s = Cube mass 1 velocity (0,-1,0) at translate (0,2,0) [nil]
process t = Cube mass 1 velocity (0,-1,0) at translate (30,2,0) [nil]
process u = Cube mass 1 at translate (60,1,0) [nil]
|}
     ^ "check a : possibly y(s) > 4 within 10");
  is "two sticky ones side by side" [ "wing"; "u" ]
    ({|
behaviour Stick on Cube = <grip, {top}>. nil
fixed floor = Cube scaled (50,1,50) at translate (0,-1,0) [Stick]
fixed wing = Cube scaled (50,1,50) at translate (100,-1,0) [Stick]
process s = Cube mass 1 velocity (0,-1,0) at translate (0,2,0) [nil]
process u = Cube mass 1 velocity (0,-1,0) at translate (100,2,0) [nil]
|}
     ^ "check a : possibly y(s) > 4 within 10")

let steered () =
  is "a steered body" all_kept
    (dimers 2
     ^ {|
process k = Cube mass 1 at translate (100,0,0) [nil]
motion k = (vx, vy - dt, vz)
check a : possibly not bound(p[1], q[1])
|})

(* Left out are those that may collide only when they let time pass. *)
let urgent_for_ever () =
  let scene =
    {|
behaviour Grip on Cube = <grip, {right}>. rho({<grip, {right}>}). Grip
behaviour Hold on Cube = <~grip, {left}>. rho({<grip, {left}>}). Hold
process s = Cube mass 1 at translate (0,50,0) [nil]
fixed w = Cube at translate (2,0,0) [Hold]
process a = Cube mass 1 velocity (1,0,0) at translate (-2,0,0) [Grip]
|}
  in
  is "they bind and split once" [ "w"; "a" ] (scene ^ "check a : always y(s) = 50 within 5");
  let between speed =
    Printf.sprintf
      {|
process s = Cube mass 1 at translate (0,1000000,0) [nil]
fixed w[1] = Cube at translate (3,0,0)
fixed w[2] = Cube at translate (-3,0,0)
process a = Cube mass 1 velocity (%d,0,0) [nil]
check a : always x(s) = 0 within 10
|}
      speed
  in
  is "they bounce to and fro" [ "w[1]"; "w[2]"; "a" ] (between 1);
  is "too often" all_kept (between 3000)

(* What is left out bounces at 1, which it must, while one of its bonds may be released, which it need not. *)
let only_what_must () =
  let scene =
    {|
behaviour Left  on Cube = omega(bond, {right}). nil
behaviour Right on Cube = omega(bond, {left}). nil
process s = Cube mass 1 velocity (0,0,1) [nil]
process d = p : Cube mass 1 at translate (0,100,0) [Left] <bond, {p.right, q.left}>
            q : Cube mass 1 at translate (2,100,0) [Right]
process b = Cube mass 1 velocity (1,0,0) at translate (100,0,0) [nil]
process c = Cube mass 1 velocity (-1,0,0) at translate (104,0,0) [nil]
check a : always z(s) <= 3/2 within 2
|}
  in
  let m, initial, formulas = load ("split_step 1\n" ^ scene) in
  let formula = List.hd formulas in
  let slice = Option.get (Slice.make (standard m) ~initial formulas) in
  let w = Option.get (witness (check Setup.default m slice formula)) in
  let lifted = Lift.timed (standard m) ~initial w in
  let label (s : Witness.step) = Transition.label_to_string m s.transition.label in
  Alcotest.(check (list string)) "the run" [ "time(1)"; "bounce(b, c)" ] (List.map label lifted.steps);
  Alcotest.(check (option string)) "lifted" None (fault m initial formula w lifted)

(* Two transitions have the same label, and the second one is meant. *)
let same_label () =
  let scene =
    {|
behaviour Left  on Cube = omega(bond, {right}). One + omega(bond, {right}). Two
behaviour One   on Cube = nil
behaviour Two   on Cube = nil
behaviour Right on Cube = omega(bond, {left}). nil
process d = p : Cube mass 1 [Left] <bond, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Right]
process s = Cube mass 1 at translate (0,100,0) [nil]
|}
  in
  let lifts name =
    let m, initial, formulas = load (scene ^ "check a : possibly behaviour(p) = " ^ name) in
    let formula = List.hd formulas in
    let slice = Option.get (Slice.make (standard m) ~initial formulas) in
    let w = Option.get (witness (check Setup.default m slice formula)) in
    Alcotest.(check (option string)) name None (fault m initial formula w (Lift.timed (standard m) ~initial w)) in
  List.iter lifts [ "One"; "Two" ]

let () =
  Alcotest.run "slice"
    [
      ("random networks", [ Scc_test_support.Property.case random; Alcotest.test_case "counts" `Quick counts ]);
      ( "by hand",
        [
          Alcotest.test_case "one of many" `Quick one_of_many;
          Alcotest.test_case "fragment" `Quick fragment;
          Alcotest.test_case "in motion" `Quick in_motion;
          Alcotest.test_case "through others" `Quick through_others;
          Alcotest.test_case "walls" `Quick walls;
          Alcotest.test_case "steered" `Quick steered;
          Alcotest.test_case "urgent for ever" `Quick urgent_for_ever;
          Alcotest.test_case "only what must" `Quick only_what_must;
          Alcotest.test_case "same label" `Quick same_label;
        ] );
    ]
