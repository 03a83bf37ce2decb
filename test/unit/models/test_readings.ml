(* Definitions, rules and readings on small models, each written for the point at issue. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks
open Scc_test_models

let standard = Scc_engine.Standard.of_model

(* {1 Models} *)

let cube =
  {|
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

let load text = Load.exactly (Load.text (cube ^ text))

let start text =
  let { Scc_elaborate.Elaborate.model; declared; _ } = load text in
  (model, Reach.initial model declared)

let labels m s =
  List.map (fun (t : Transition.t) -> Transition.label_to_string m t.label) (Reach.successors m s)

let take m s label =
  let named (t : Transition.t) = String.equal (Transition.label_to_string m t.label) label in
  match List.find_opt named (Reach.successors m s) with
  | Some t -> t.target
  | None -> Alcotest.failf "no %s among %s" label (String.concat "; " (labels m s))

let after m s path = List.fold_left (take m) s path
let check_labels what expected m s = Alcotest.(check (list string)) what expected (labels m s)

let leaf m name =
  let rec find i = if String.equal m.Model.leaves.(i).Model.name name then i else find (i + 1) in
  find 0

let velocity m s name =
  Vec.to_string (Option.get (State.home s (leaf m name))).velocity

let check_velocity m s name expected = Alcotest.(check string) name expected (velocity m s name)

let refused text expected () =
  match Load.text (cube ^ text) with
  | Ok _ -> Alcotest.failf "accepted: %s" text
  | Error diagnostics ->
    let codes = List.map (fun (d : Scc_base.Diag.t) -> d.code) diagnostics in
    Alcotest.(check (list string)) text [ expected ] (List.sort_uniq String.compare codes)

(* {1 Terms} *)

let degenerate_features () =
  refused "behaviour K on Cube = <a, {[a,a]}>. nil process p = Cube mass 1 [K]" "SC0203" ();
  refused "behaviour K on Cube = <a, {[a,c]}>. nil process p = Cube mass 1 [K]" "SC0203" ();
  refused "behaviour K on Cube = <a, {[a,d,b]}>. nil process p = Cube mass 1 [K]" "SC0203" ()

let face_tuples () =
  let site text =
    let m, _ = start (Printf.sprintf "process p = Cube mass 1 [<a, {%s}>. nil]" text) in
    let _, s = start (Printf.sprintf "process p = Cube mass 1 [<a, {%s}>. nil]" text) in
    match Behaviours.offers m.definitions s.processes.(0).leaves.(0).behaviour with
    | [ Offer_open (_, c, _) ] -> List.map (Model.site_name m ~leaf:0) c.sites
    | _ -> Alcotest.fail "not one offer"
  in
  let check text expected = Alcotest.(check (list string)) text expected (site text) in
  check "top" [ "p.top" ];
  check "[e,f,g,h]" [ "p.top" ];
  check "[h,e,f,g]" [ "p.top" ];
  check "[b,a]" [ "p.[a,b]" ];
  refused "process p = Cube mass 1 [<a, {[h,g,f,e]}>. nil]" "SC0203" ()

let omega_syntax () =
  ignore (load "process p = Cube mass 1 [omega(a, {top}). nil]");
  refused "process p = Cube mass 1 [omega(<a, {top}>). nil]" "SC0110" ()

(* Two facing cubes that bind on what their channels have in common. *)
let facing ?(left = "<a, {right}>. nil") ?(right = "<~a, {left}>. nil") () =
  Printf.sprintf
    "process p = Cube mass 1 velocity (1,0,0) [%s] process q = Cube mass 1 at translate (3,0,0) [%s]" left right

let redundant_lists () =
  let binds left =
    let m, s = start (facing ~left ()) in
    labels m (after m s [ "time(1)" ])
  in
  Alcotest.(check (list string))
    "features of the closure may be listed, and change nothing"
    (binds "<a, {right}>. nil")
    (binds "<a, {right, [b,c], c, g}>. nil");
  let reacts entries =
    let m, s =
      start
        (Printf.sprintf
           "process p = Cube mass 1 [rho({%s}). nil] process q = Cube mass 1 at translate (2,0,0) [rho({<a, \
            {left}>}). nil] bond <a, {p.right, q.left}>"
           entries)
    in
    labels m s
  in
  let check what = Alcotest.(check (list string)) what [ "strong({<a, {p.right, q.left}>})" ] in
  check "an entry twice" (reacts "<a, {right}>, <a, {right}>");
  check "twice, with a redundant list (I-17)" (reacts "<a, {right}>, <a, {right, [b,c]}>");
  Alcotest.(check (list string)) "two entries for one bond" [] (reacts "<a, {right}>, <a, {right, top}>")

let lower_list () =
  let m, s = start (facing ~left:"<a, {[b,c], c, [e,f]}>. nil" ()) in
  check_labels "an edge that lies on an edge: the contact of the highest dimension"
    [ "bind(a, p.[b,c], q.[a,d])" ]
    m
    (after m s [ "time(1)" ])

let zero_delay () =
  let m, s = start (facing ~left:"eps(0). eps(0). <a, {right}>. nil" ()) in
  check_labels "bound as without" [ "bind(a, p.right, q.left)" ] m (after m s [ "time(1)" ]);
  let _, without = start (facing ()) in
  Alcotest.(check bool) "one state" true (State.equal s without)

let brackets () =
  let chain = "Cube mass 1 [nil]" in
  let leaf name x = Printf.sprintf "%s : Cube mass 1 at translate (%d,0,0) [nil]" name x in
  let bond one two = Printf.sprintf "<a, {%s.right, %s.left}>" one two in
  let p, q, r = (leaf "p" 0, leaf "q" 2, leaf "r" 4) in
  let first = Printf.sprintf "process n = (%s %s %s) %s %s" p (bond "p" "q") q (bond "q" "r") r in
  let second = Printf.sprintf "process n = %s %s (%s %s %s)" p (bond "p" "q") q (bond "q" "r") r in
  let apart =
    Printf.sprintf "process p = %s process q = %s process r = %s bond <a, {r.left, q.right}> bond %s" chain
      "Cube mass 1 at translate (2,0,0) [nil]" "Cube mass 1 at translate (4,0,0) [nil]" (bond "p" "q")
  in
  let state text = snd (start text) in
  Alcotest.(check bool) "bracketing" true (State.equal (state first) (state second));
  Alcotest.(check bool) "bonds declared apart, ends exchanged" true (State.equal (state first) (state apart))

let recognised () =
  let m, s = start (facing ~left:"nil" ~right:"nil" ()) in
  let moved = Time.pass (standard m) (Rat.make Z.one (Z.of_int 2)) s in
  Alcotest.(check bool) "another place, another state" false (State.equal s moved);
  let p = s.processes.(0) in
  let slower =
    State.process ~leaves:(Array.to_list p.leaves) ~bonds:[] ~velocity:Vec.zero ~clock:None ()
  in
  let s' =
    State.make ~processes:[ s.processes.(1); slower ] ~step:s.step ~time:s.time
  in
  Alcotest.(check bool) "another velocity, another state" false (State.equal s s');
  let again = State.make ~processes:[ s.processes.(1); p ] ~step:s.step ~time:s.time in
  Alcotest.(check bool) "in any order" true (State.equal s again);
  Alcotest.(check int) "one hash" (State.hash s) (State.hash again)

let touching_without_glue () =
  let part name x y =
    Printf.sprintf "part %s : Cube mass 1 at translate (%d,%d,0)" name x y
  in
  let parts = String.concat " " [ part "u" 0 0; part "v" 2 0; part "w" 2 2; part "x" 0 2 ] in
  let glues = "glue u.right ~ v.left glue v.back ~ w.front glue w.left ~ x.right" in
  ignore (load (Printf.sprintf "compound Ring { %s %s } process p = Ring [nil]" parts glues));
  refused
    (Printf.sprintf "compound Ring { %s %s glue x.front ~ u.back } process p = Ring [nil]" parts glues)
    "SC0405" ()

(* {1 Collisions} *)

let touching_is_no_collision () =
  let text =
    {|process p = Cube mass 1 [<a, {right}>. nil]
      process q = Cube mass 1 at translate (2,0,0) [<~a, {left}>. nil]|}
  in
  let m, s = start text in
  check_labels "at rest in contact, with open channels" [] m s;
  Alcotest.(check bool) "quiescent" true (Network.quiescent (standard m) s)

(* q slides down along v and lands on u: the two processes collide, and bind wherever they touch. *)
let landing ~head ~after () =
  let labels_with open_ =
    let text =
      head ^
      "compound L { part u : Cube mass 1 part w : Cube mass 1 at translate (2,0,0) part v : Cube mass 1 at \
       translate (2,2,0) glue u.right ~ w.left glue w.back ~ v.front }\n"
      ^ Printf.sprintf "process p = L [<a, {%s}>. nil]\n" open_
      ^ "process q = Cube mass 1 velocity (0,-1,0) at translate (0,4,0) [<~a, {right, front}>. nil]"
    in
    let m, s = start text in
    labels m (after m s)
  in
  let check what expected got = Alcotest.(check (list string)) what expected got in
  check "where it slides" [ "bind(a, p.v.left, q.right)" ] (labels_with "v.left");
  check "where it lands" [ "bind(a, p.u.back, q.front)" ] (labels_with "u.back");
  check "on both" [ "bind(a, p.u.back, q.front)"; "bind(a, p.v.left, q.right)" ] (labels_with "u.back, v.left");
  check "not where they do not touch" [ "bounce(p, q)" ] (labels_with "u.front")

let every_contact_binds = landing ~head:"" ~after:(fun m s -> after m s [ "time(2)" ])

(* Where nothing spins the instant of a contact is exact in rigid models, too. *)
let near_contact_binds =
  landing ~head:"dynamics constant_spin\n" ~after:(fun m s -> after m s [ "time(2)" ])

(* The channel b is open on an edge alone, and a on the whole face: each is compatible by itself. *)
let highest_of_each () =
  let m, s =
    start (facing ~left:"<a, {right}>. nil + <b, {[b,c]}>. nil" ~right:"<~a, {left}>. nil + <~b, {left}>. nil" ())
  in
  check_labels "of each two channels" [ "bind(a, p.right, q.left)"; "bind(b, p.[b,c], q.[a,d])" ] m
    (after m s [ "time(1)" ])

(* p hits q and r, which lie side by side, at their common border. *)
let hits_two () =
  let text head =
    head
    ^ "process p = Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [nil] process q = Cube mass 1 at translate \
       (0,1,0) [nil] process r = Cube mass 1 at translate (0,-1,0) [nil]"
  in
  let m, s = start (text "") in
  check_labels "one by one (I-8)" [ "bounce(p, q)"; "bounce(p, r)" ] m (after m s [ "time(1)" ]);
  let m, s = start (text "collisions together ") in
  let s = after m s [ "time(1)" ] in
  check_labels "as one" [ "bounce(p, q, r)" ] m s;
  let s = after m s [ "bounce(p, q, r)" ] in
  let velocity i = Scc_exact.Vec.to_string s.processes.(i).State.velocity in
  Alcotest.(check (list string))
    "both alike"
    [ "(-1/3, 0, 0)"; "(2/3, 0, 0)"; "(2/3, 0, 0)" ]
    (List.init 3 velocity);
  check_labels "and that is all" [] m s;
  let m, s =
    start
      "collisions together fixed floor = Cube scaled (20,1,20) at translate (0,-2,0) process p = Cube mass 1 \
       velocity (0,-1,0) at translate (-5,1,0) [nil] process q = Cube mass 1 velocity (0,-1,0) at \
       translate (5,1,0) [nil]"
  in
  check_labels "a floor links nobody" [ "bounce(floor, p)"; "bounce(floor, q)" ] m (after m s [ "time(1)" ])

(* The surfaces of p and q meet in an edge while q slides by; those of r and s when a channel opens. *)
let by_contact () =
  let text head =
    head
    ^ "process p = Cube mass 1 [<a, {right}>. nil] process q = Cube mass 1 velocity (0,-1,0) at translate (2,5,0) \
       [<~a, {[a,e]}>. nil] process r = Cube mass 1 at translate (40,0,0) [<~b, {top}>. nil] process s = \
       Cube mass 1 at translate (40,0,2) [eps(2). <b, {bottom}>. nil]"
  in
  let m, s = start (text "") in
  check_labels "not without the switch (I-12)" [] m (after m s [ "time(2)" ]);
  let m, s = start (text "binding contact ") in
  let s = after m s [ "time(2)" ] in
  check_labels "a channel opens, and no time passes" [ "bind(b, r.top, s.bottom)" ] m s;
  let s = after m s [ "bind(b, r.top, s.bottom)"; "time(1)" ] in
  check_labels "the first instant at which surfaces meet" [ "bind(a, p.[c,g], q.[a,e])" ] m s

(* p comes to touch the left of q, and r the edge between right and back of p: across the middle of four. *)
let without_closure () =
  let text listed =
    let right = listed "right" ^ ", " ^ listed "back" and left = listed "left" ^ ", " ^ listed "front" in
    Printf.sprintf
      "process p = Cube mass 1 velocity (1,1,0) at translate (-3,-3,0) [<a, {%s}>. nil]\n\
       process q = Cube mass 1 [<~a, {%s}>. nil]\n\
       process r = Cube mass 1 velocity (1,0,0) at translate (-3,40,0) [<a, {%s}>. nil]\n\
       process s = Cube mass 1 at translate (0,40,0) [<~a, {%s}>. nil]"
      right left right left
  in
  let first m s = after m s [ "time(1)" ] in
  let m, s = start (text Fun.id) in
  let edge = "bind(a, p.[c,g], q.[a,e])" and face = "bind(a, r.right, s.left)" in
  check_labels "by the face, and at the edge" [ edge; face ] m (first m s);
  let m, s = start (text (fun f -> "only " ^ f)) in
  check_labels "by the face alone" [ "bounce(p, q)"; face ] m (first m s);
  let m, s = start (text (fun f -> f ^ ", only " ^ f)) in
  check_labels "unless its closure is listed as well" [ edge; face ] m (first m s)

let many_apart () =
  let text =
    {|for i in 1..20 { process c[i] = Cube mass 1 velocity (i, i*i, 0) at translate (3*i, 3*i*i, 0) [nil] }|}
  in
  let m, s = start text in
  check_labels "they fly apart for ever" [] m s;
  let alike =
    "for i in 1..20 { process c[i] = Cube mass 1 velocity (1,0,0) at translate (3*i, 0, 0) [nil] }"
  in
  let m, s = start alike in
  check_labels "they fly side by side for ever" [] m s

let separate_tiles () =
  let text =
    "fixed left = Cube at translate (-1,-1,0) fixed right = Cube at translate (1,-1,0)\n\
     process p = Cube mass 1 velocity (-1,-1,0) at translate (2,2,0) [nil]"
  in
  let m, s = start text in
  let s = after m s [ "time(1)" ] in
  check_labels "two bodies, two collisions" [ "bounce(left, p)"; "bounce(right, p)" ] m s;
  check_velocity m (take m s "bounce(right, p)") "p" "(-1, 1, 0)";
  check_velocity m (take m s "bounce(left, p)") "p" "(1, 1, 0)"

(* {1 Splits} *)

let from_rest () =
  let text =
    "process p = Cube mass 1 velocity (-1,0,0) at translate (3,0,0) [<a, {left}>. omega(a, {left}). nil]\n\
     fixed w = Cube [<~a, {right}>. omega(a, {right}). nil]"
  in
  let m, s = start text in
  let s = after m s [ "time(1)"; "bind(a, p.left, w.right)" ] in
  check_velocity m s "p" "(0, 0, 0)";
  let s = after m s [ "weak(a, p.left, w.right)" ] in
  check_velocity m s "p" "(0, 0, 0)";
  check_labels "and stays there" [] m s

let dimer rest =
  rest
  ^ "process n = p : Cube mass 1 [omega(a, {right}). nil] <a, {p.right, q.left}> q : Cube mass 1 at translate \
     (2,0,0) [eps(3/4). omega(a, {left}). nil]"

let clocks_recur () =
  let m, s = start (dimer "split_step 1/2 ") in
  let s = after m s [ "time(3/4)" ] in
  check_labels "releasable when both are ready: at once" [ "weak(a, p.right, q.left)"; "time(1/2)" ] m s;
  Alcotest.(check bool) "and one split step later it is the same state" true
    (State.equal s (after m s [ "time(1/2)" ]))

let default_step () =
  let m, s = start (dimer "timestep 1/8 ") in
  check_labels "Delta by default" [ "weak(a, p.right, q.left)"; "time(1/8)" ] m (after m s [ "time(3/4)" ])

(* {1 Time} *)

let jumps () =
  let m, s = start ("timestep 1/100 " ^ facing ()) in
  check_labels "no movement steps without a law" [ "time(1)" ] m s;
  let m, s = start ("timestep 1/4 motion p = (vx, vy, vz) " ^ facing ()) in
  check_labels "with one, step by step" [ "time(1/4)" ] m s

(* p bounces at odd moments; the velocity of q, whose law adds g*dt, is g times the time all the same. *)
let cut_steps () =
  let text gap =
    Printf.sprintf
      "timestep 1/4 fixed floor = Cube scaled (9,9,1) at translate (0,0,-1)\n\
       process p = Cube mass 1 velocity (0,0,-1) at translate (0,0,%s) [nil]\n\
       process q = Cube mass 1 at translate (5,0,9) [nil]\n\
       motion q = (vx, vy, vz - 8*dt)"
      gap
  in
  let at_one gap =
    let m, s = start (text gap) in
    let rec go s now =
      if Rat.equal now Rat.one then velocity m s "q"
      else
        match Reach.successors m s with
        | [ t ] -> go t.target (Rat.add now (Transition.duration t))
        | _ -> Alcotest.fail "not one transition"
    in
    go s Rat.zero
  in
  Alcotest.(check string) "undisturbed" "(0, 0, -8)" (at_one "100");
  (* p bounces at 1/3: steps end at 1/4, 1/3, 7/12, 5/6 *)
  let m, s = start (text "4/3") in
  let path = [ "time(1/4)"; "time(1/12)"; "bounce(floor, p)" ] in
  check_velocity m (after m s path) "q" "(0, 0, -8/3)"

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "readings"
    [
      ( "terms",
        [
          case "D-6: degenerate features" degenerate_features;
          case "Def-4.1: a face by any rotation of its tuple" face_tuples;
          case "D-19: omega(a, {...})" omega_syntax;
          case "D-21: redundant lists" redundant_lists;
          case "I-4: the highest of those that are listed" lower_list;
          case "Eps0: eps(0).B is B" zero_delay;
          case "Def-5.2, I-5: brackets and ends" brackets;
          case "State: equality" recognised;
          case "D-17: rings of parts" touching_without_glue;
        ] );
      ( "collisions",
        [
          case "I-12: contact without approach binds nothing" touching_is_no_collision;
          case "I-12: processes that collide bind wherever they touch" every_contact_binds;
          case "I-12: likewise within the resolution" near_contact_binds;
          case "D-24: the highest dimension is that of two channels" highest_of_each;
          case "I-32: a cube that hits two moves both alike" hits_two;
          case "I-33: channels that open or slide into place" by_contact;
          case "I-34: features without their closure" without_closure;
          case "Ftoc: many bodies that never meet" many_apart;
          case "D-34: tiles that are separate bodies" separate_tiles;
        ] );
      ( "splits",
        [
          case "I-11: from a fixed body, from rest" from_rest;
          case "I-16: split clocks recur" clocks_recur;
          case "I-9: the split step is Delta by default" default_step;
        ] );
      ( "time",
        [ case "Jump: only a law makes steps" jumps; case "I-10: steps that collisions cut short" cut_steps ] );
    ]
