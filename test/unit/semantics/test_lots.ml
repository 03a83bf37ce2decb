(* Rule Lot: splits that are left to chance. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture

let chance q name faces rest = Behaviour.weak ~odds:(Chance q) (channel name faces) rest

let network ?splits ?definitions ?velocity bodies bonds =
  let m = { (model ?splits ?definitions bodies) with lots = true } in
  (m, start m (joined ?velocity bodies bonds))

let well_formed what m s = Alcotest.(check bool) what true (Well_formed.check (standard m) s = [])
let pair = [ ("a", (0, "right"), (1, "left")) ]
let half = ratio 1 2

let released = "release(a, p.right, q.left) chance(1/4)"
let kept = "keep(a, p.right, q.left) chance(3/4)"

let one_bond () =
  let bodies =
    [
      body "p" (0, 0, 0) ~behaviour:(chance (ratio 1 4) "a" [ "right" ] nil);
      body "q" (2, 0, 0) ~behaviour:(weak "a" [ "left" ] nil);
    ]
  in
  let m, s = network ~velocity:(1, 0, 0) bodies pair in
  check_labels "none at the start" [ "time(1)" ] m s;
  let s = take m s "time(1)" in
  check_labels "both ways, and nothing else" [ released; kept ] m s;
  well_formed "a state like others" m s;
  Alcotest.(check bool) "something is to come" false (Network.quiescent (standard m) s);
  check_labels "what is kept waits for the next instant" [ "time(1)" ] m (take m s kept);
  let let_go = take m s released in
  well_formed "so is this one" m let_go;
  check_labels "what is to be released is" [ "weak(a, p.right, q.left)" ] m let_go;
  let s = take m let_go "weak(a, p.right, q.left)" in
  check_labels "into two, that rest" [] m s;
  Alcotest.(check (list string)) "which go on as the whole did" [ "(1, 0, 0)"; "(1, 0, 0)" ]
    [ velocity s 0; velocity s 1 ];
  well_formed "and this one" m s

(* Chances of 0 and 1, and chances on the one end alone that the other does not offer at all. *)
let ends_of_the_scale () =
  let two q behaviour =
    let bodies =
      [ body "p" (0, 0, 0) ~behaviour:(chance q "a" [ "right" ] nil); body "q" (2, 0, 0) ~behaviour ]
    in
    let m, s = network bodies pair in
    (m, s, labels m (successors m s))
  in
  let free = weak "a" [ "left" ] nil in
  let _, _, never = two Rat.zero free in
  Alcotest.(check (list string)) "never: the network rests" [] never;
  let _, _, alone = two half nil in
  Alcotest.(check (list string)) "both must offer it" [] alone;
  let m, s, _ = two Rat.one free in
  check_labels "surely" [ "release(a, p.right, q.left) chance(1)" ] m (take m s "time(1)")

let both_ends () =
  let bodies =
    [
      body "p" (0, 0, 0) ~behaviour:(chance half "a" [ "right" ] nil);
      body "q" (2, 0, 0) ~behaviour:(chance (ratio 1 3) "a" [ "left" ] nil);
    ]
  in
  let m, s = network bodies pair in
  check_labels "the product"
    [ "release(a, p.right, q.left) chance(1/6)"; "keep(a, p.right, q.left) chance(5/6)" ]
    m (take m s "time(1)")

(* What an end without a chance does is a free choice; so are bonds that both release freely, at their own
   instants. *)
let several_ways () =
  let definitions : Behaviour.definitions = [| { name = "One"; body = nil }; { name = "Two"; body = nil } |] in
  let one = Behaviour.call 0 and two = Behaviour.call 1 in
  let behaviour = chance (ratio 1 2) "a" [ "right" ] one + chance (ratio 1 3) "a" [ "right" ] two in
  let bodies =
    [
      body "p" (0, 0, 0) ~behaviour;
      body "q" (2, 0, 0) ~behaviour:(weak "a" [ "left" ] one + weak "a" [ "left" ] two);
    ]
  in
  let m, s = network ~definitions bodies pair in
  check_labels "no free split at the start" [ "time(1)" ] m s;
  let s = take m s "time(1)" in
  check_labels "each with its own, and the rest"
    [
      "release(a, p.right, q.left) chance(1/2)"; "release(a, p.right, q.left) chance(1/3)";
      "keep(a, p.right, q.left) chance(1/6)";
    ]
    m s;
  let s = take m s "release(a, p.right, q.left) chance(1/3)" in
  let behaviours (t : Transition.t) =
    List.map (fun i -> (State.leaf_of (Option.get (State.home t.target i)) i).behaviour.origin) [ 0; 1 ]
  in
  Alcotest.(check (list (list (option int)))) "by what it drew, and any of what the other may do"
    [ [ Some 1; Some 0 ]; [ Some 1; Some 1 ] ]
    (List.map behaviours (successors m s))

(* q holds p and r, and lets go of one of them only. *)
let who_is_first () =
  let once = chance half "a" [ "left" ] nil + chance half "a" [ "right" ] nil in
  let bodies =
    [
      body "r" (4, 0, 0) ~behaviour:(weak "a" [ "left" ] nil); body "q" (2, 0, 0) ~behaviour:once;
      body "p" (0, 0, 0) ~behaviour:(weak "a" [ "right" ] nil);
    ]
  in
  let m, s = network bodies [ ("a", (2, "right"), (1, "left")); ("a", (1, "right"), (0, "left")) ] in
  let s = take m s "time(1)" in
  check_labels "the first by place, in whatever order they are declared"
    [ "release(a, q.left, p.right) chance(1/2)"; "keep(a, q.left, p.right) chance(1/2)" ]
    m s;
  let s = take m s "release(a, q.left, p.right) chance(1/2)" in
  let s = take m s "release(a, r.left, q.right) chance(1/2)" in
  well_formed "both are to be released" m s;
  check_labels "each may be first, alike"
    [ "first(a, q.left, p.right) chance(1/2)"; "first(a, r.left, q.right) chance(1/2)" ]
    m s;
  let s = take m s "first(a, r.left, q.right) chance(1/2)" in
  well_formed "one is" m s;
  check_labels "and is released" [ "weak(a, r.left, q.right)" ] m s;
  let s = take m s "weak(a, r.left, q.right)" in
  well_formed "the other one is kept" m s;
  check_labels "for ever, as q offers no more" [] m s

(* Three in a row that offer again what they have offered: both bonds go, one after the other. *)
let all_of_them () =
  let definitions : Behaviour.definitions =
    [| { name = "Again"; body = chance half "a" [ "left"; "right" ] (Behaviour.call 0) } |]
  in
  let again = Behaviour.call 0 in
  let bodies = List.init 3 (fun i -> body (Printf.sprintf "b%d" i) (Int.mul 2 i, 0, 0) ~behaviour:again) in
  let m, s = network ~definitions bodies [ ("a", (0, "right"), (1, "left")); ("a", (1, "right"), (2, "left")) ] in
  let s =
    List.fold_left (take m) s
      [
        "time(1)"; "release(a, b0.right, b1.left) chance(1/4)"; "release(a, b1.right, b2.left) chance(1/4)";
        "first(a, b1.right, b2.left) chance(1/2)"; "weak(a, b1.right, b2.left)"; "weak(a, b0.right, b1.left)";
      ]
  in
  Alcotest.(check int) "three processes" 3 (Array.length s.processes);
  check_labels "and nothing is to come" [] m s

let beside_free behaviour =
  [ body "p" (0, 0, 0) ~behaviour; body "q" (2, 0, 0) ~behaviour:(weak "a" [ "left" ] nil) ]

let sum_beyond_one () =
  let too_much = chance (ratio 2 3) "a" [ "right" ] nil + chance half "a" [ "right"; "top" ] (eps half nil) in
  let m, s = network (beside_free too_much) pair in
  match Network.successors (standard m) (take m s "time(1)") with
  | Ok _ -> Alcotest.fail "no error"
  | Error fault ->
    let d = Transition.diagnostic m fault in
    Alcotest.(check (pair string string)) "named, with its code"
      ("SC0603", "the chances with which `p` releases a bond at p.right sum to more than 1")
      ((d.code :> string), d.message)

(* Twice the same is twice the chance, also if one is a name: it is no matter how what follows is written. *)
let repeated () =
  let twice = chance (ratio 1 4) "a" [ "right" ] nil + Behaviour.call 0 in
  let definitions : Behaviour.definitions = [| { name = "K"; body = chance (ratio 1 4) "a" [ "right" ] nil } |] in
  let m, s = network ~definitions (beside_free twice) pair in
  let one_half = "release(a, p.right, q.left) chance(1/2)" in
  check_labels "one half" [ one_half; "keep(a, p.right, q.left) chance(1/2)" ] m (take m s "time(1)");
  let released = List.fold_left (take m) s [ "time(1)"; one_half ] in
  check_labels "and one way to release it" [ "weak(a, p.right, q.left)" ] m released;
  let quarter = chance (ratio 1 4) "a" [ "right" ] nil in
  let m, s = network (beside_free (eps (q 3) nil + quarter + eps half quarter)) pair in
  check_labels "also when it comes later"
    [ "release(a, p.right, q.left) chance(1/2)"; "keep(a, p.right, q.left) chance(1/2)" ]
    m (List.fold_left (take m) s [ "time(1/2)"; "time(1/2)" ])

(* The bond becomes releasable at 1/4, and a wall is hit at 1/2 and so on: it makes no difference. One that
   becomes so at a split instant after the lots were drawn waits for the next. *)
let instants () =
  let late = eps (ratio 1 4) (chance (ratio 1 4) "a" [ "right" ] nil) in
  let bodies =
    [
      body "p" (0, 0, 0) ~behaviour:late; body "q" (2, 0, 0) ~behaviour:(weak "a" [ "left" ] nil);
      body "w" (0, 3, 0) ~fixed:true; body "v" (0, -3, 0) ~fixed:true;
    ]
  in
  let m = { (model bodies) with lots = true } in
  let all = declared bodies in
  let whole = (joined ~velocity:(0, 2, 0) [ List.nth bodies 0; List.nth bodies 1 ] pair).processes.(0) in
  let s = start m (State.make ~processes:[ whole; all.processes.(2); all.processes.(3) ] ~step:None ~time:None) in
  let s = List.fold_left (take m) s [ "time(1/4)"; "time(1/4)"; "bounce(p, w)"; "time(1/2)" ] in
  check_labels "at 1, though the whole has bounced at 1/2" [ released; kept ] m s;
  well_formed "a state like others" m s;
  let s = List.fold_left (take m) s [ kept; "time(1/2)" ] in
  check_labels "and then the next wall" [ "bounce(p, v)" ] m s;
  let opens = eps (q 1) (chance (ratio 1 4) "a" [ "right" ] nil) in
  let m, s = network (beside_free opens) pair in
  check_labels "what opens as the instant comes is drawn for" [ released; kept ] m (take m s "time(1)")

(* Laws are asked after the lots: each piece draws for itself. *)
let before_laws () =
  let law = Law.Choose [ { velocity = (Const (q 1), Const (q 0), Const (q 0)); weight = Const (q 1) } ] in
  let bodies =
    [
      body "p" (0, 0, 0) ~law ~behaviour:(chance (ratio 1 4) "a" [ "right" ] nil);
      body "q" (2, 0, 0) ~law ~behaviour:(weak "a" [ "left" ] nil);
    ]
  in
  let m, s = network bodies pair in
  let s = List.fold_left (take m) s [ "draw(p, (1, 0, 0)) chance(1)"; "time(1)" ] in
  check_labels "lots first" [ released; kept ] m s;
  let s = List.fold_left (take m) s [ released; "weak(a, p.right, q.left)" ] in
  check_labels "then draws, of each" [ "draw(p, (1, 0, 0)) chance(1)" ] m s;
  check_labels "one after the other" [ "draw(q, (1, 0, 0)) chance(1)" ] m (take m s "draw(p, (1, 0, 0)) chance(1)")

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("lots",
   [
     ( "lots",
       [
         case "Lot: one bond" one_bond;
         case "Lot: chances of 0 and 1" ends_of_the_scale;
         case "Lot: both ends draw" both_ends;
         case "Lot: several ways" several_ways;
         case "Lot: who is first" who_is_first;
         case "Lot: all of them" all_of_them;
         case "Lot: chances that sum to more than 1" sum_beyond_one;
         case "Lot: what is repeated counts twice" repeated;
         case "Lot: before laws are asked" before_laws;
         case "I-39: instants of the network" instants;
       ] );
   ])
