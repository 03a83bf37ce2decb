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

(* {1 Bonds of several processes} *)

(* Processes of bodies that bonds [a] join, each leaf to the one that is declared next. *)
let rows ?definitions rows =
  let bodies = List.concat rows in
  let leaves = List.mapi leaf bodies in
  let bond i : State.bond =
    State.bond "a" { at = i; site = site "right" } { at = Int.add i 1; site = site "left" }
  in
  let rec processes first = function
    | [] -> []
    | row :: rest ->
      let n = List.length row in
      let is_mine (l : State.leaf) = l.leaf >= first && l.leaf < Int.add first n in
      let bonds = List.init (Int.sub n 1) (fun i -> bond (Int.add first i)) in
      State.process ~leaves:(List.filter is_mine leaves) ~bonds ~velocity:Vec.zero ~clock:None ()
      :: processes (Int.add first n) rest
  in
  let m = { (model ?definitions bodies) with lots = true } in
  (m, start m (State.make ~processes:(processes 0 rows) ~step:None ~time:None))

let dimer p q x behaviour other = [ body p (x, 0, 0) ~behaviour; body q (Int.add x 2, 0, 0) ~behaviour:other ]

let two_pairs () =
  let lets_go = chance half "a" [ "right" ] nil and free = weak "a" [ "left" ] nil in
  let m, s = rows [ dimer "p" "q" 0 lets_go free; dimer "u" "v" (-20) lets_go free ] in
  let s = List.fold_left (take m) s [ "time(1)"; "release(a, u.right, v.left) chance(1/2)" ] in
  check_labels "the other draws before anything is released"
    [ "release(a, p.right, q.left) chance(1/2)"; "keep(a, p.right, q.left) chance(1/2)" ]
    m s;
  well_formed "half drawn" m s;
  check_labels "one is kept" [ "weak(a, u.right, v.left)" ] m (take m s "keep(a, p.right, q.left) chance(1/2)");
  let s = take m s "release(a, p.right, q.left) chance(1/2)" in
  let both = "weak({<a, {p.right, q.left}>, <a, {u.right, v.left}>})" in
  check_labels "both go at once" [ both ] m s;
  let s = take m s both in
  Alcotest.(check int) "four processes" 4 (Array.length s.processes);
  check_labels "and nothing is to come" [] m s

(* Two rows of three whose middle ones let go on both sides, and do so again. *)
let rounds () =
  let definitions : Behaviour.definitions =
    [| { name = "Again"; body = chance Rat.one "a" [ "left"; "right" ] (Behaviour.call 0) } |]
  in
  let row names x =
    let free = weak "a" [ "left"; "right" ] nil in
    List.mapi
      (fun i name ->
         body name (Int.add x (Int.mul 2 i), 0, 0) ~behaviour:(if i = 1 then Behaviour.call 0 else free))
      names
  in
  let m, s = rows ~definitions [ row [ "p"; "q"; "r" ] 0; row [ "u"; "v"; "w" ] (-20) ] in
  let go = List.fold_left (take m) in
  let s =
    go s
      [
        "time(1)"; "release(a, u.right, v.left) chance(1)"; "release(a, v.right, w.left) chance(1)";
        "release(a, p.right, q.left) chance(1)"; "release(a, q.right, r.left) chance(1)";
      ]
  in
  check_labels "when all have drawn, who is first"
    [ "first(a, u.right, v.left) chance(1/2)"; "first(a, v.right, w.left) chance(1/2)" ]
    m s;
  let s = take m s "first(a, v.right, w.left) chance(1/2)" in
  well_formed "one first" m s;
  check_labels "of the others, too, before one is released"
    [ "first(a, p.right, q.left) chance(1/2)"; "first(a, q.right, r.left) chance(1/2)" ]
    m s;
  let s = take m s "first(a, p.right, q.left) chance(1/2)" in
  well_formed "two first" m s;
  check_labels "the first ones at once" [ "weak({<a, {p.right, q.left}>, <a, {v.right, w.left}>})" ] m s;
  let s = take m s "weak({<a, {p.right, q.left}>, <a, {v.right, w.left}>})" in
  well_formed "after them" m s;
  check_labels "and then the others" [ "weak({<a, {q.right, r.left}>, <a, {u.right, v.left}>})" ] m s

let who_chooses () =
  let definitions : Behaviour.definitions =
    [| { name = "One"; body = nil }; { name = "Two"; body = nil } |]
  in
  let lets_go = chance Rat.one "a" [ "right" ] nil in
  let either = weak "a" [ "left" ] (Behaviour.call 0) + weak "a" [ "left"; "top" ] (Behaviour.call 1) in
  let m, s = rows ~definitions [ dimer "p" "q" 0 lets_go either; dimer "u" "v" (-20) lets_go either ] in
  let drawn = [ "time(1)"; "release(a, u.right, v.left) chance(1)"; "release(a, p.right, q.left) chance(1)" ] in
  let s = List.fold_left (take m) s drawn in
  let choose = "choose(a, u.right, v.left)" and both = "weak({<a, {p.right, q.left}>, <a, {u.right, v.left}>})" in
  check_labels "after all lots" [ choose; choose ] m s;
  let behaviours (t : Transition.t) =
    List.map (fun i -> (State.leaf_of (Option.get (State.home t.target i)) i).behaviour.origin) [ 1; 3 ]
  in
  let ends (t : Transition.t) =
    well_formed "chosen" m t.target;
    check_labels "the last one chooses as it goes" [ both; both ] m t.target;
    List.map behaviours (successors m t.target)
  in
  Alcotest.(check (list (list (option int)))) "each with each"
    [ [ Some 0; Some 0 ]; [ Some 1; Some 0 ]; [ Some 0; Some 1 ]; [ Some 1; Some 1 ] ]
    (List.concat_map ends (successors m s));
  let is_free (t : Transition.t) = not (Transition.is_drawn t.label) in
  Alcotest.(check bool) "a free choice" true (List.for_all is_free (successors m s));
  let same = weak "a" [ "left" ] nil + weak "a" [ "left"; "top" ] nil in
  let m, s = rows [ dimer "p" "q" 0 lets_go same; dimer "u" "v" (-20) lets_go same ] in
  check_labels "nothing to choose where the same comes of both" [ both ] m (List.fold_left (take m) s drawn)

(* One after the other, the first push would move what the second one has not left yet. *)
let pushes_at_once () =
  let pushes face = Behaviour.weak ~odds:(Chance Rat.one) ~push:Rat.one (channel "a" [ face ]) nil in
  let free face = weak "a" [ face ] nil in
  let bodies =
    List.mapi
      (fun i behaviour -> body (Printf.sprintf "b%d" i) (Int.mul 2 i, 0, 0) ~behaviour)
      [ pushes "right"; free "left"; free "right"; pushes "left" ]
  in
  let m, s = rows [ bodies ] in
  let release b c = Printf.sprintf "release(a, %s.right, %s.left) chance(1)" b c in
  let s = List.fold_left (take m) s [ "time(1)"; release "b0" "b1"; release "b2" "b3" ] in
  let s = take m s "weak({<a, {b0.right, b1.left}> push(1), <a, {b2.right, b3.left}> push(1)})" in
  Alcotest.(check (list string)) "alike to both sides" [ "(-1, 0, 0)"; "(0, 0, 0)"; "(0, 0, 0)"; "(1, 0, 0)" ]
    (List.map (velocity s) [ 0; 1; 2; 3 ])

(* Rates compete among themselves, and a chance is what it says. *)
let beside_rates () =
  let rate r = Odds.Rate { rate = r; alone = Odds.within ~step:Rat.one r } in
  let ends odds =
    let summand odds = Behaviour.weak ~odds (channel "a" [ "right" ]) nil in
    List.fold_left ( + ) (summand (List.hd odds)) (List.map summand (List.tl odds))
  in
  let quarter = ratio 1 4 in
  let dimer odds = rows [ dimer "p" "q" 0 (ends odds) (weak "a" [ "left" ] nil) ] in
  let m, s = dimer [ rate quarter; Chance quarter; rate half ] in
  let together = Odds.within ~step:Rat.one (ratio 3 4) in
  let third = Rat.div together (q 3) in
  let release c = Printf.sprintf "release(a, p.right, q.left) chance(%s)" (Rat.to_string c) in
  let keep = Rat.sub (ratio 3 4) together in
  check_labels "each its own"
    [
      release third; release quarter; release (Rat.add third third);
      Printf.sprintf "keep(a, p.right, q.left) chance(%s)" (Rat.to_string keep);
    ]
    m (take m s "time(1)");
  let m, s = dimer [ Chance half; rate Rat.one ] in
  match Network.successors (standard m) (take m s "time(1)") with
  | Error (Transition.Bad_chance _) -> ()
  | Error _ | Ok _ -> Alcotest.fail "1/2 and 1 - 1/e are more than 1"

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

(* They bind at 1/2, between two instants. *)
let bound_between () =
  let bodies =
    [
      body "p" (0, 0, 0) ~velocity:(2, 0, 0)
        ~behaviour:(open_ "a" [ "right" ] (chance (ratio 1 4) "a" [ "right" ] nil));
      body "q" (3, 0, 0) ~behaviour:(co_open "a" [ "left" ] (weak "a" [ "left" ] nil));
    ]
  in
  let m = { (model bodies) with lots = true } in
  let s = List.fold_left (take m) (start m (declared bodies)) [ "time(1/2)"; "bind(a, p.right, q.left)" ] in
  well_formed "a state like others" m s;
  check_labels "at 1, and not at 3/2" [ released; kept ] m (take m s "time(1/2)")

(* Laws are asked after the lots: each piece draws for itself. *)
let before_laws () =
  let motion = Law.velocity_alone (Const (q 1), Const (q 0), Const (q 0)) in
  let law = Law.Choose [ { motion; weight = Const (q 1) } ] in
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
         case "Lot: two pairs at once" two_pairs;
         case "Lot: rounds" rounds;
         case "Lot: who chooses" who_chooses;
         case "Lot: pushes at once" pushes_at_once;
         case "Lot: chances beside rates" beside_rates;
         case "Lot: chances that sum to more than 1" sum_beyond_one;
         case "Lot: what is repeated counts twice" repeated;
         case "Lot: before laws are asked" before_laws;
         case "I-39: instants of the network" instants; case "I-39: bound between two" bound_between;
       ] );
   ])
