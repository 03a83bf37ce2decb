(* Rule Close: bonds that close rings (reading I-37). *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture

let cyclic m = { m with Model.bonds = Cyclic }

(* Four cubes in a square: p and q below s and r. Three bonds join them, all but p and s. *)
let places = [ ("p", (0, 0, 0)); ("q", (2, 0, 0)); ("r", (2, 0, 2)); ("s", (0, 0, 2)) ]

let link one two = ("link", one, two)
let last_link = link (0, "top") (3, "bottom")
let links = [ link (0, "right") (1, "left"); link (1, "top") (2, "bottom"); link (2, "left") (3, "right") ]

let bodies ?(fixed = false) behaviours =
  List.map2 (fun (name, at) behaviour -> body name at ~fixed:(fixed && name = "q") ~behaviour) places behaviours

let square ?(fixed = false) ?velocity ?(behaviours = [ nil; nil; nil; nil ]) ?(bonds = links) () =
  let bodies = bodies ~fixed behaviours in
  let m = cyclic (model bodies) in
  (m, start m (joined ?velocity bodies bonds))

let up = open_ "a" [ "top" ]
let down = co_open "a" [ "bottom" ]
let only_process (s : State.t) =
  match s.processes with [| p |] -> p | _ -> Alcotest.failf "%d processes" (Array.length s.processes)

let close = "close(a, p.top, s.bottom)"

let closes () =
  let m, s = square ~velocity:(3, 0, 0) ~behaviours:[ up (eps (q 1) nil); nil; nil; down nil ] () in
  check_labels "nothing else is possible, no time passes" [ close ] m s;
  let t = only_process (take m s close) in
  Alcotest.(check int) "four bonds" 4 (Array.length t.bonds);
  Alcotest.(check string) "it moves on" "(3, 0, 0)" (Vec.to_string t.velocity);
  check_labels "its ends continue" [ "time(1)" ] m (take m s close);
  let acyclic = { m with bonds = Acyclic } in
  check_labels "bonds are a tree, if nothing is said" [ "time(1)" ] acyclic
    (start acyclic (joined (bodies [ up nil; nil; nil; eps (q 1) (down nil) ]) links));
  let m, s = square ~behaviours:[ up nil; nil; nil; eps (q 1) (down nil) ] () in
  check_labels "a channel that opens later closes the ring then" [ close ] m (take m s "time(1)")

let none () =
  let nothing what behaviours =
    let m, s = square ~behaviours () in
    check_labels what [] m s
  in
  nothing "the same polarity" [ up nil; nil; nil; open_ "a" [ "bottom" ] nil ];
  nothing "another name" [ up nil; nil; nil; co_open "b" [ "bottom" ] nil ];
  nothing "a feature that does not touch" [ up nil; nil; nil; co_open "a" [ "top" ] nil ];
  nothing "leaves that do not touch" [ nil; up nil; nil; open_ "a" [ "left" ] nil ];
  nothing "leaves that a bond joins" [ open_ "a" [ "right" ] nil; co_open "a" [ "left" ] nil; nil; nil ]

(* One bond of each two leaves, however often they offer it. *)
let once () =
  let p = up (up nil) + open_ "b" [ "top" ] nil and s = down (down nil) + co_open "b" [ "bottom" ] nil in
  let m, s = square ~behaviours:[ p; nil; nil; s ] () in
  check_labels "each candidate" [ close; "close(b, p.top, s.bottom)" ] m s;
  check_labels "and no second bond" [] m (take m s close)

(* Of an edge, which closures hold: p and r touch in one. *)
let by_an_edge () =
  let m, s = square ~behaviours:[ up nil; nil; co_open "a" [ "left" ] nil; nil ] () in
  (match labels m (successors m s) with
   | [ label ] ->
     let bond = List.hd (Transition.bonds (List.hd (successors m s)).label) in
     let is_edge (f : State.finish) = match f.site.feature with Edge _ -> true | Vertex _ | Face _ -> false in
     Alcotest.(check bool) label true (is_edge bond.one && is_edge bond.two)
   | several -> Alcotest.failf "%d closings" (List.length several));
  let only name features =
    let sites = List.map site features in
    Behaviour.channel ~name ~sites ~closure:sites ()
  in
  let m, s =
    square
      ~behaviours:[ Behaviour.open_ Name (only "a" [ "top" ]) nil; nil; co_open "a" [ "left" ] nil; nil ]
      ()
  in
  check_labels "not of a face without its edges (I-34)" [] m s;
  let m, s = square ~behaviours:[ up nil; nil; co_open "a" [ "left" ] nil; down nil ] () in
  Alcotest.(check int) "either neighbour" 2 (List.length (successors m s))

(* A cube that meets two others of one process binds to one, and closes with the other, in both orders. *)
let orders () =
  let any = [ "left"; "right"; "top"; "bottom" ] in
  let both = open_ "a" any in
  let m, s =
    square ~behaviours:[ both (both nil); co_open "a" any nil; nil; co_open "a" any nil ]
      ()
  in
  check_labels "q is joined" [ close ] m s;
  let right = open_ "a" [ "right" ] and left = co_open "a" [ "left" ] nil in
  let three =
    [
      body "p" (0, 0, 0) ~velocity:(1, 0, 0) ~behaviour:(right (right nil));
      body "q" (2, 0, 1) ~behaviour:left; body "r" (2, 0, -1) ~behaviour:left;
    ]
  in
  let m = cyclic (model three) in
  let s = declared three in
  let bound = State.process ~leaves:[ leaf 1 (List.nth three 1); leaf 2 (List.nth three 2) ]
      ~bonds:[ State.bond "link" { at = 1; site = site "bottom" } { at = 2; site = site "top" } ]
      ~velocity:Vec.zero ~clock:None () in
  let s = start m (State.make ~processes:[ s.processes.(0); bound ] ~step:None ~time:None) in
  check_labels "three that meet at once" [ "bind(a, p.right, q.left)"; "bind(a, p.right, r.left)" ] m s;
  let one = take m s "bind(a, p.right, q.left)" and two = take m s "bind(a, p.right, r.left)" in
  check_labels "then the other" [ "close(a, p.right, r.left)" ] m one;
  check_labels "and the other way" [ "close(a, p.right, q.left)" ] m two;
  Alcotest.(check bool) "come to the same" true
    (State.equal (take m one "close(a, p.right, r.left)") (take m two "close(a, p.right, q.left)"))

(* A collision of the same instant, with a body that comes to q from the right. *)
let with_a_collision () =
  let bodies = bodies [ up nil; nil; nil; down nil ] @ [ body "hit" (4, 0, 0) ~velocity:(-1, 0, 0) ] in
  let m = cyclic (model bodies) in
  let whole = (joined (List.filteri (fun i _ -> i < 4) bodies) links).processes.(0) in
  let s = start m (State.make ~processes:[ whole; (declared bodies).processes.(4) ] ~step:None ~time:None) in
  check_labels "either first" [ close; "bounce(p, hit)" ] m s;
  let a = take m (take m s close) "bounce(p, hit)" and b = take m (take m s "bounce(p, hit)") close in
  Alcotest.(check bool) "with the same outcome" true (State.equal a b)

let with_a_fixed_leaf () =
  let m, s = square ~fixed:true ~behaviours:[ up nil; nil; nil; down nil ] () in
  check_labels "like any other" [ close ] m s

let release faces = weak "a" faces

(* The ring stays one when a bond of it goes, and its clock starts anew with every change. *)
let splits () =
  let m, s = square ~behaviours:[ up (release [ "top" ] nil); nil; nil; down (release [ "bottom" ] nil) ] () in
  let s = take m s close in
  check_labels "its clock starts" [ "weak(a, p.top, s.bottom)"; "time(1)" ] m s;
  let s = take m s "weak(a, p.top, s.bottom)" in
  Alcotest.(check int) "still one, of three bonds" 3 (Array.length (only_process s).bonds);
  let react faces = strong (List.map (fun f -> ("link", [ f ])) faces) nil in
  let reacting p q r s = square ~bonds:(last_link :: links) ~behaviours:[ p; q; r; s ] () in
  let p = react [ "right"; "top" ] and q = react [ "left"; "top" ] and r = react [ "bottom"; "left" ] in
  let m, s = reacting p q r (react [ "right"; "bottom" ]) in
  (match successors m s with
   | [ { label = Strong_split x; target; _ } ] ->
     Alcotest.(check int) "all four bonds at once" 4 (List.length x);
     Alcotest.(check int) "four pieces" 4 (Array.length target.processes)
   | _ -> Alcotest.fail "one reaction was expected");
  let m, s = reacting p q r (react [ "right" ]) in
  check_labels "no leaf leaves out a bond of the reaction" [] m s;
  let m, s = reacting (react [ "right" ]) (react [ "left" ]) nil nil in
  let target = take m s "strong({<link, {p.right, q.left}>})" in
  Alcotest.(check int) "one bond alone opens the ring" 3 (Array.length (only_process target).bonds)

(* What a reaction releases may close again at once, and so on, within one instant. *)
let round () =
  let definitions : Behaviour.definitions =
    [|
      { name = "Up"; body = up (strong [ ("a", [ "top" ]) ] (Behaviour.call 0)) };
      { name = "Down"; body = down (strong [ ("a", [ "bottom" ]) ] (Behaviour.call 1)) };
    |]
  in
  let bodies = bodies [ Behaviour.call 0; nil; nil; Behaviour.call 1 ] in
  let m = cyclic (model ~definitions bodies) in
  let s = start m (joined bodies links) in
  let again = take m (take m s close) "strong({<a, {p.top, s.bottom}>})" in
  Alcotest.(check bool) "back where it was" true (State.equal s again)

(* {1 Pushes: both ends are of one piece} *)

let pushed e = Behaviour.strong ~push:(q 3) [ channel "link" [ e ] ] nil

let ring_with_a_push () =
  square ~velocity:(0, 5, 0) ~bonds:(last_link :: links) ~behaviours:[ pushed "right"; pushed "left"; nil; nil ] ()

let the_push = "strong({<link, {p.right, q.left}> push(6)})"

let pushes_cancel () =
  let m, s = ring_with_a_push () in
  Alcotest.(check string) "nothing moves otherwise" "(0, 5, 0)"
    (Vec.to_string (only_process (take m s the_push)).velocity)

(* {1 Bodies that turn} *)

let rigid ?(dynamics = Model.Constant_spin) (m, (s : State.t)) ~spin =
  let m = { m with Model.rigid = Some { dynamics; resolution = ratio 1 1024; round_orientation = None } } in
  let p = State.with_turn ~spin ~since:Rat.zero ~lasts:None s.processes.(0) in
  (m, start m (State.make ~processes:[ p ] ~step:None ~time:None))

let spin = Vec.make (ratio 1 3) (ratio (-1) 2) (ratio 1 4)

let turning () =
  let later b = eps (ratio 1 8) b in
  let m, s = rigid ~spin (square ~velocity:(1, 0, 0) ~behaviours:[ up nil; nil; nil; later (down nil) ] ()) in
  let before = take m s "time(1/8)" in
  check_labels "turned as it is, it closes" [ close ] m before;
  let p = only_process before and p' = only_process (take m before close) in
  Alcotest.(check bool) "in the middle of its turn" true (Rat.sign p.since > 0 && Rat.equal p.since p'.since);
  Alcotest.(check bool) "which goes on as it is" true
    (Vec.equal p.velocity p'.velocity && Vec.equal p.spin p'.spin && Vec.equal p.kept p'.kept
     && Option.equal Rat.equal p.lasts p'.lasts)

let turning_pushes () =
  let check dynamics =
    let m, s = rigid ~dynamics ~spin (ring_with_a_push ()) in
    let p = only_process s and p' = only_process (take m s the_push) in
    Alcotest.(check bool) "impulses cancel, as do their moments" true
      (Vec.equal p.velocity p'.velocity && Vec.equal p.kept p'.kept
       && (dynamics <> Model.Constant_spin || Vec.equal p.spin p'.spin))
  in
  check Constant_spin;
  check Free_body

(* A compound leaf of two cubes, below one that lies on both: its parts do not bind with each other, and either may
   bind with the other leaf. *)
let compound () =
  let bodies =
    [ body "p" (0, 0, 0); body "q" (4, 0, 0); body "s" (1, 0, 2) ~behaviour:(down nil); body "t" (4, 0, 2) ]
  in
  let m = cyclic (model bodies) in
  let double i (l : Model.leaf) =
    if i > 0 then l
    else
      let part name x = { (l.parts.(0)) with name; offset = Vec.of_ints x 0 0 } in
      { l with parts = [| part "p.one" 0; part "p.two" 2 |] }
  in
  let m = { m with leaves = Array.mapi double m.leaves } in
  let any face part = { Site.part; feature = Fixture.face face } in
  let channel = Behaviour.channel ~name:"a" ~sites:[ any "top" 0; any "top" 1; any "left" 1; any "right" 0 ]
      ~closure:[ any "top" 0; any "top" 1; any "left" 1; any "right" 0 ] () in
  let behaviour = Behaviour.sum (Behaviour.open_ Name channel nil) (Behaviour.open_ Co_name channel nil) in
  let finish at part f : State.finish = { at; site = any f part } in
  let leaves = List.mapi (fun i b -> leaf i (if i = 0 then { b with behaviour } else b)) bodies in
  let bonds =
    [ State.bond "link" (finish 0 1 "right") (finish 1 0 "left");
      State.bond "link" (finish 1 0 "top") (finish 3 0 "bottom");
      State.bond "link" (finish 2 0 "right") (finish 3 0 "left") ]
  in
  let whole = State.process ~leaves ~bonds ~velocity:Vec.zero ~clock:None () in
  let s = start m (State.make ~processes:[ whole ] ~step:None ~time:None) in
  let one = "close(a, p.one.top, s.bottom)" and two = "close(a, p.two.top, s.bottom)" in
  check_labels "with the other leaf alone" [ one; two ] m s;
  Alcotest.(check int) "and once" 0 (List.length (successors m (take m s two)))

(* {1 What is well formed} *)

let well_formed () =
  let m, s = square ~bonds:(last_link :: links) () in
  let faults m = List.length (Well_formed.check (standard m) s) in
  Alcotest.(check int) "a ring" 0 (faults m);
  Alcotest.(check int) "not where bonds are a tree" 1 (faults { m with bonds = Acyclic });
  let m, s = square ~bonds:(("other", (0, "right"), (1, "left")) :: links) () in
  Alcotest.(check int) "not two bonds of two leaves" 1 (List.length (Well_formed.check (standard m) s));
  let m, s =
    square ~bonds:[ List.hd links; ("other", (1, "left"), (0, "right")); ("third", (0, "right"), (1, "left")) ] ()
  in
  Alcotest.(check int) "nor two pieces" 1 (List.length (Well_formed.check (standard m) s))

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("closing",
   [
     ( "cases",
       [
         case "Close: two leaves of one process" closes; case "Close: when nothing closes" none;
         case "Close: one bond of each two leaves" once; case "Close: by an edge" by_an_edge;
         case "Close: three that meet at once" orders;
         case "Close: at the instant of a collision" with_a_collision;
         case "Close: with a fixed leaf" with_a_fixed_leaf; case "I-37: splits of a ring" splits;
         case "I-37: round within an instant" round; case "I-37: a push within a ring" pushes_cancel;
         case "Close: bodies that turn" turning; case "I-37: a push within a ring that turns" turning_pushes;
         case "Close: parts of one leaf do not close" compound;
         case "WellFormed: bonds that close rings (I-37)" well_formed;
       ] );
   ])
