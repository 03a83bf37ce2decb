(* Which transitions the patterns of formulas mean, on the transitions of small models, and where the atom
   [event] holds. *)

open Scc_ctl
open Scc_exact
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_test_models

let standard = Scc_engine.Standard.of_model

let cube =
  {|
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
|}

(* The initial state of a model, and what its checks say, without the operator of each. *)
let load text =
  let e = Load.exactly (Load.text (cube ^ text)) in
  match Network.initial (standard e.model) e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok s -> (e, s)

let event_of (k : Property.check) =
  match k.formula with
  | Finally (_, _, State (Fact (Event e))) -> e
  | _ -> Alcotest.fail "not a formula of this test"

let successors m s =
  match Network.successors (standard m) s with
  | Ok list -> list
  | Error _ -> Alcotest.fail "no successors"

(* The first transition of a kind, breadth first. *)
let find m start wanted =
  let rec look depth states =
    if depth = 0 then Alcotest.fail "no such transition"
    else
      let next = List.concat_map (fun s -> List.map (fun t -> (s, t)) (successors m s)) states in
      match List.find_opt (fun (_, (t : Transition.t)) -> wanted t.label) next with
      | Some found -> found
      | None -> look (depth - 1) (List.map (fun (_, (t : Transition.t)) -> t.target) next)
  in
  look 6 [ start ]

let is_time : Transition.label -> bool = function Time _ -> true | _ -> false
let is_bind : Transition.label -> bool = function Bind _ -> true | _ -> false
let is_bounce : Transition.label -> bool = function Bounce _ -> true | _ -> false
let is_weak : Transition.label -> bool = function Weak_split _ -> true | _ -> false
let is_absorb : Transition.label -> bool = function Absorb _ -> true | _ -> false
let is_strong : Transition.label -> bool = function Strong_split _ -> true | _ -> false

(* Each pattern, and whether the first transition of the kind is one of it. *)
let patterns model wanted cases () =
  let check i (pattern, _) = Printf.sprintf "check k%d : possibly event %s\n" i pattern in
  let checks = List.mapi check cases in
  let e, start = load (model ^ String.concat "" checks) in
  let source, t = find e.model start wanted in
  List.iter2
    (fun k (pattern, expected) ->
       Alcotest.(check bool) pattern expected (Event.matches ~source t.label (event_of k)))
    e.checks cases

(* p binds to q on the channel a with its right face, r is elsewhere; another name is around. *)
let binding =
  {|
process p = Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [<a, {right}>. nil + <b, {top}>. nil]
process q = Cube mass 1 at translate (3,0,0) [<~a, {left}>. nil]
process r = Cube mass 1 at translate (0,50,0) [nil]
|}

let of_a_bind =
  [
    ("bind", true); ("bind(a)", true); ("bind(b)", false); ("bind(a, p)", true); ("bind(a, q)", true);
    ("bind(a, r)", false); ("bind(a, p, q)", true); ("bind(a, q, p)", true); ("bind(a, p, r)", false);
    ("bind(b, p, q)", false); ("weak", false); ("strong", false); ("split(a)", false); ("bounce", false);
    ("bounce(p, q)", false);
  ]

(* The pair p1-p2 meets q: the processes bounce, though p1 is not the one that is hit. *)
let bouncing =
  {|
process p = p1 : Cube mass 1 velocity (1,0,0) at translate (-5,0,0) [nil] <a, {p1.right, p2.left}>
            p2 : Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [nil]
process q = Cube mass 1 at translate (3,0,0) [nil]
process r = Cube mass 1 at translate (0,50,0) [nil]
|}

let of_a_bounce =
  [
    ("bounce", true); ("bounce(p1)", true); ("bounce(p2)", true); ("bounce(q)", true); ("bounce(r)", false);
    ("bounce(p1, q)", true); ("bounce(q, p2)", true); ("bounce(p1, p2)", false); ("bounce(p1, r)", false);
    ("bounce(q, q)", false); ("hit(p2)", true); ("hit(q)", true); ("hit(p1)", false); ("hit(r)", false);
    ("hit(p2, q)", true); ("hit(q, p2)", true); ("hit(p1, q)", false); ("hit(p2, p1)", false);
    ("bind", false); ("split", false); ("bind(a, p1, p2)", false);
  ]

(* The lower part of a compound meets q, the upper one passes it. *)
let bouncing_by_parts =
  {|
compound Arm { part low : Cube mass 1  part high : Cube mass 1 at translate (0,2,0)  glue low.back ~ high.front }
process arm = Arm velocity (1,0,0) at translate (-3,0,0) [nil]
process q = Cube mass 1 at translate (3,-1/2,0) [nil]
|}

let of_a_bounce_by_parts =
  [
    ("bounce(arm, q)", true); ("hit(arm)", true); ("hit(arm.low)", true); ("hit(arm.high)", false);
    ("hit(arm.low, q)", true); ("hit(q, arm.low)", true); ("hit(q, arm.high)", false);
    ("hit(arm.low, arm)", false); ("hit(arm, q)", true);
  ]

let pair left right =
  Printf.sprintf
    {|
process p = p1 : Cube mass 1 [%s] <a, {p1.right, p2.left}> p2 : Cube mass 1 at translate (2,0,0) [%s]
            <b, {p2.right, p3.left}> p3 : Cube mass 1 at translate (4,0,0) [nil]
|}
    left right

let splitting_weakly = pair "omega(a, {right}). nil" "omega(a, {left}). nil"

let of_a_weak_split =
  [
    ("weak", true); ("weak(a)", true); ("weak(b)", false); ("weak(a, p1, p2)", true); ("weak(a, p3)", false);
    ("strong", false); ("strong(a)", false); ("split", true); ("split(a, p2)", true); ("split(b)", false);
    ("bind(a)", false); ("bounce(p1)", false);
  ]

(* Both bonds go at once: it is an event of each. *)
let splitting_strongly =
  {|
process p = p1 : Cube mass 1 [rho({<a, {right}>}). nil] <a, {p1.right, p2.left}>
            p2 : Cube mass 1 at translate (2,0,0) [rho({<a, {left}>, <b, {right}>}). nil]
            <b, {p2.right, p3.left}> p3 : Cube mass 1 at translate (4,0,0) [rho({<b, {left}>}). nil]
|}

let of_a_strong_split =
  [
    ("strong", true); ("strong(a)", true); ("strong(b)", true); ("strong(a, p1, p2)", true);
    ("strong(b, p3, p2)", true); ("strong(a, p3)", false); ("strong(b, p1)", false); ("weak(a)", false);
    ("split(b)", true); ("split(a, p1, p3)", false); ("bind(b)", false);
  ]

let never pattern = (pattern, false)

let of_time =
  List.map never [ "bind"; "weak"; "strong"; "split"; "bounce"; "bind(a)"; "bounce(p)"; "bounce(p, q)" ]

(* {1 Counted} *)

(* How much happens by the first transition of the kind of which it is so. *)
let counts model wanted cases () =
  let check i (events, _) = Printf.sprintf "check k%d : possibly %s\n" i events in
  let e, start = load (model ^ String.concat "" (List.mapi check cases)) in
  let source, t = find e.model start wanted in
  let prop (k : Property.check) =
    match k.formula with Finally (_, _, State p) -> p | _ -> Alcotest.fail "not a formula of this test"
  in
  List.iter2
    (fun k (events, expected) ->
       let n = Counted.by (standard e.model) ~source t.label (prop k) in
       Alcotest.(check (pair int int)) events (expected, expected) (n.least, n.most))
    e.checks cases

(* Each of the two bonds by itself. *)
let counted_of_a_strong_split =
  [
    ("event strong", 2); ("event split", 2); ("event strong(a)", 1); ("event strong(b, p2)", 1);
    ("event strong(b, p2, p3)", 1);
    ("(event strong(a) or event strong(b))", 2); ("(event strong(a) and event strong(b))", 0);
    ("(event strong and not event strong(a))", 1); ("not event strong(a)", 1); ("not event bind", 2);
    ("event weak", 0);
  ]

let counted_of_a_bind =
  [ ("event bind", 1); ("event bind(a, q, p)", 1); ("not event bind", 0); ("not event bounce", 1) ]

(* The pair is hit on both sides at once. *)
let bouncing_together =
  {|
collisions together
process p = Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [nil]
process q = Cube mass 1 [nil]
process r = Cube mass 1 velocity (-1,0,0) at translate (3,0,0) [nil]
|}

let counted_of_a_bounce =
  [ ("event bounce", 1); ("event bounce(q)", 1); ("event hit(q)", 1);
    ("(event hit(p, q) and event hit(q, r))", 1) ]

let absorbing =
  {|
fixed drain = Cube absorb
process p = p1 : Cube mass 1 velocity (1,0,0) at translate (-5,0,0) [nil] <a, {p1.right, p2.left}>
            p2 : Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [nil]
|}

let counted_of_an_absorption =
  [ ("event absorb", 1); ("event absorb(p1)", 1); ("(event absorb(p1) and event absorb(p2))", 1);
    ("not event bind", 1) ]

let counted_of_time = [ ("event bind", 0); ("not event bind", 0) ]

(* {1 Along a trajectory} *)

let along () =
  let e, s = load (binding ^ "check k : possibly event bind(a)") in
  let event = event_of (List.hd e.checks) in
  let truths ?arrived extent p =
    let t = Trajectory.prop (Trajectory.make ?arrived (standard e.model) s extent) p in
    (Timeline.at t Algebraic.zero, Timeline.at t (Algebraic.of_rat (Rat.make Z.one (Z.of_int 2))))
  in
  let check name expected (start, later) =
    Alcotest.(check (pair bool bool)) name expected
      (Truth.equal start True, Truth.equal later True)
  in
  let arrived e = Formula.equal_event e event in
  let lasts = Timeline.Lasts Rat.one in
  check "nothing has led here" (false, false) (truths lasts (Fact (Event event)));
  check "at the start alone" (true, false) (truths ~arrived lasts (Fact (Event event)));
  check "for ever after not" (true, false) (truths ~arrived Timeline.Forever (Fact (Event event)));
  check "another event" (false, false) (truths ~arrived lasts (Fact (Event (Bounce Any))));
  check "not" (false, true) (truths ~arrived lasts (Not (Fact (Event event))));
  check "not, without one" (true, true) (truths lasts (Not (Fact (Event event))));
  check "with others" (true, false) (truths ~arrived lasts (And [ Fact (Event event); Not (Fact Quiescent) ]))

let case name run = Alcotest.test_case name `Quick run

let suite =
  ("events",
   [
     ( "transitions",
       [
         case "a bind" (patterns binding is_bind of_a_bind);
         case "a bounce" (patterns bouncing is_bounce of_a_bounce);
         case "a bounce of parts" (patterns bouncing_by_parts is_bounce of_a_bounce_by_parts);
         case "a weak split" (patterns splitting_weakly is_weak of_a_weak_split);
         case "a strong split" (patterns splitting_strongly is_strong of_a_strong_split);
         case "a passing of time" (patterns binding is_time of_time);
       ] );
     ( "counted",
       [
         case "each bond of a strong split" (counts splitting_strongly is_strong counted_of_a_strong_split);
         case "one bind" (counts binding is_bind counted_of_a_bind);
         case "one bounce of several" (counts bouncing_together is_bounce counted_of_a_bounce);
         case "one absorption" (counts absorbing is_absorb counted_of_an_absorption);
         case "no passing of time" (counts binding is_time counted_of_time);
       ] );
     ("trajectories", [ case "where an event holds" along ]);
   ])
