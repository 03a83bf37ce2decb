(* What elaboration makes of models that are in order. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_property
open Models

let standard = Scc_engine.Standard.of_model

let same_rational name expected x = Alcotest.(check string) name (Rat.to_string expected) (Rat.to_string x)
let splits : Model.splits -> string = function Every q -> Rat.to_string q | Any_time -> "any"
let same_splits name expected x = Alcotest.(check string) name (splits expected) (splits x)
let same_vector name expected x = Alcotest.(check string) name (Vec.to_string expected) (Vec.to_string x)
let q n d = Rat.make (Z.of_int n) (Z.of_int d)
let leaf_names (t : Scc_elaborate.Elaborate.t) =
  Array.to_list (Array.map (fun (l : Model.leaf) -> l.name) t.model.leaves)

let leaf_index t name =
  let rec from i = function
    | [] -> Alcotest.failf "no leaf %s" name
    | n :: _ when String.equal n name -> i
    | _ :: rest -> from (i + 1) rest
  in
  from 0 (leaf_names t)

let leaf (t : Scc_elaborate.Elaborate.t) name = t.model.leaves.(leaf_index t name)
let state_leaf (t : Scc_elaborate.Elaborate.t) name = 
  let leaf = leaf_index t name in
  State.leaf_of (Option.get (State.home t.declared leaf)) leaf

let process_of (t : Scc_elaborate.Elaborate.t) name =
  Option.get (State.home t.declared (leaf_index t name))

let strings = Alcotest.(list string)

(* {1 Names, loops, values} *)

(* The greatest coordinates of the vertices. *)
let greatest (s : Scc_geometry.Solid.t) =
  let merge (a : Vec.t) (b : Vec.t) = Vec.make (Rat.max a.x b.x) (Rat.max a.y b.y) (Rat.max a.z b.z) in
  let vertices = Array.mapi (fun i _ -> Scc_geometry.Solid.vertex s i) s.vertices in
  Array.fold_left merge vertices.(0) vertices

let loops () =
  let t =
    accept
      (cube
       ^ "param n = 2 for i in 1..n, j in i..n { process g[i,j] = Cube mass 1 \
          at translate (4*i, 4*j, 0) [nil] }\n\
          for i in 1..0 { process none[i] = Cube mass 1 [nil] }\n\
          for i in -1..-1 { let k = 2*i process c[2*k] = Cube mass 1 at translate (0, 0, k) [nil] }")
  in
  Alcotest.(check strings) "names" [ "g[1,1]"; "g[1,2]"; "g[2,2]"; "c[-4]" ] (leaf_names t);
  same_vector "place" (Vec.of_ints 4 8 0) (state_leaf t "g[1,2]").position

let overrides () =
  let text = "param n = 2 param m = n*n timestep m split_step 1/n" in
  let t = accept ~overrides:[ ("n", q 3 1) ] text in
  Alcotest.(check (list (pair string string)))
    "values"
    [ ("n", "3"); ("m", "9") ]
    (List.map (fun (name, x) -> (name, Rat.to_string x)) t.parameters);
  same_rational "timestep" (q 9 1) t.model.timestep;
  same_splits "split step" (Every (q 1 3)) t.model.splits

let defaults () =
  let t = accept "model m param unused = 1" in
  same_rational "timestep" Rat.one t.model.timestep;
  same_splits "split step" (Every Rat.one) t.model.splits;
  Alcotest.(check (option string)) "name" (Some "m") t.name;
  same_splits "split step follows the timestep" (Every (q 1 4)) (accept "timestep 1/4").model.splits;
  same_splits "at any time" Any_time (accept "timestep 1/4 split_step any").model.splits;
  same_splits "a parameter of that name" (Every (q 1 3)) (accept "param any = 1/3 split_step any").model.splits

let scopes () =
  let t =
    accept
      (cube
       ^ "param i = 7 let k = i + 1 for i in 1..1 { process c[i] = Cube mass (k) \
          at translate (i, 0, 0) [nil] }\n\
          process p = Cube mass (if i > 3 and not false then round(i, 2) else 1) at translate (9, 0, 0) [nil]")
  in
  same_rational "a let sees its own scope" (q 8 1) (leaf t "c[1]").mass;
  same_vector "an inner name hides an outer one" (Vec.of_ints 1 0 0) (state_leaf t "c[1]").position;
  same_rational "conditions and rounding" (q 8 1) (leaf t "p").mass

(* {1 Shapes} *)

let solids () =
  let t =
    accept
      (cube
       ^ "shape Plank = Cube scaled (2, 1/2, 1)\n\
          process p = Cube mass 1 [nil] process q = Cube mass 1 at translate (5,0,0) [nil]\n\
          process r = Cube mass 1 at translate (10,0,0) * rotate quaternion (1,0,0,1) [nil]\n\
          process s = Cube scaled (2, 1/2, 1) mass 1 at translate (20,0,0) [nil]\n\
          process u = Plank mass 1 at translate (30,0,0) [nil]\n\
          process w = Cube mass 1 at translate (40,0,0) * scale (2, 2, 2) * translate (1,1,1) [nil]")
  in
  let solid name = (leaf t name).parts.(0).solid in
  let id name = (solid name).id in
  Alcotest.(check int) "equal bodies share a solid" (id "p") (id "q");
  Alcotest.(check int) "so do images by one scaling" (id "s") (id "u");
  Alcotest.(check bool) "a turned one is another" false (Int.equal (id "p") (id "r"));
  same_vector "scaled" (Vec.make (q 2 1) (q 1 2) (q 1 1)) (greatest (solid "u"));
  Alcotest.(check string) "a template by scaling has its name" "Plank" (leaf t "u").template;
  Alcotest.(check string) "scaled in place it keeps the other's" "Cube" (leaf t "s").template;
  same_vector "the last transformation is the first applied" (Vec.of_ints 42 2 2)
    (state_leaf t "w").position;
  same_vector "linear part" (Vec.of_ints 2 2 2) (greatest (solid "w"));
  Alcotest.(check (list string)) "templates in order" [ "Cube"; "Plank" ] (List.map fst t.templates)

let matrix () =
  let t =
    accept
      (cube ^ "process p = Cube mass 1 at matrix ((0,-1,0,5),(1,0,0,6),(0,0,2,7),(0,0,0,1)) [nil]")
  in
  same_vector "translation" (Vec.of_ints 5 6 7) (state_leaf t "p").position;
  same_vector "linear part" (Vec.of_ints 1 1 2) (greatest (leaf t "p").parts.(0).solid)

let compound () =
  let t = accept (cube ^ corner ^ "process p = Corner velocity (1,0,0) \
                                   at translate (0,0,5) * rotate quaternion (1,0,0,1) [nil]") in
  let p = leaf t "p" in
  Alcotest.(check strings) "parts" [ "p.left"; "p.arm" ]
    (Array.to_list (Array.map (fun (x : Model.part) -> x.name) p.parts));
  same_rational "mass" (q 6 1) p.mass;
  (* a quarter turn about z takes (3, 1/2, 0) to (-1/2, 3, 0) *)
  same_vector "part" (Vec.make (q (-1) 2) (q 3 1) Rat.zero) p.parts.(1).offset;
  same_vector "turned" (Vec.make (q 1 2) (q 2 1) (q 1 1)) (greatest p.parts.(1).solid);
  same_vector "velocity" (Vec.of_ints 1 0 0) (process_of t "p").velocity

let compound_velocity () =
  let text attribute =
    cube
    ^ "compound C { part l : Cube mass 1 velocity (1,2,3) part r : Cube mass 1 velocity (1,2,3) \
       at translate (2,0,0) glue l.right ~ r.left }\n\
       process p = C " ^ attribute ^ " [nil]"
  in
  same_vector "of the parts" (Vec.of_ints 1 2 3) (process_of (accept (text "")) "p").velocity;
  same_vector "of the process" (Vec.of_ints 0 0 1)
    (process_of (accept (text "velocity (0,0,1)")) "p").velocity

let mesh () =
  let off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n" in
  let read_file path = if String.equal path "t.off" then Ok off else Error "?" in
  let t = accept ~read_file "shape T = mesh \"t.off\" process p = T mass 1 [<a, {f0, [v1,v2]}>. nil]" in
  Alcotest.(check int) "vertices" 4 (Array.length (snd (List.hd t.templates)).vertices);
  Alcotest.(check (list string)) "off centre" [ "SC0312" ] (List.map (fun (d : Diag.t) -> d.code) t.warnings)

(* {1 Behaviours} *)

let sites (t : Scc_elaborate.Elaborate.t) name =
  match (state_leaf t name).behaviour.term with
  | Behaviour.Open (_, c, _) -> List.map (Model.site_name t.model ~leaf:(leaf_index t name)) c.sites
  | _ -> Alcotest.fail "a channel was expected"

let features () =
  let t =
    accept
      (cube ^ corner
       ^ "process p = Cube mass 1 [<a, {top, p.a, [b,a], [p.e, p.f, p.g, p.h], [d,c,b,a]}>. nil]\n\
          process q = Corner at translate (20,0,0) [<a, {left.top, q.arm.[a,b], [left.a, left.b]}>. nil]\n\
          for i in 1..1 { process c[i] = Cube mass 1 at translate (0,9,0) [<a, {c[i].top}>. nil] }")
  in
  Alcotest.(check strings) "basic" [ "p.a"; "p.[a,b]"; "p.bottom"; "p.top" ] (sites t "p");
  Alcotest.(check strings) "compound" [ "q.left.[a,b]"; "q.left.top"; "q.arm.[a,b]" ] (sites t "q");
  Alcotest.(check strings) "indexed" [ "c[1].top" ] (sites t "c[1]");
  match (state_leaf t "q").behaviour.term with
  | Behaviour.Open (_, c, _) ->
    (* a top with 4 edges and 4 corners, an edge with 2 and an edge with 2 *)
    Alcotest.(check int) "closure" (1 + 4 + 4 + (1 + 2) + (1 + 2)) (List.length c.surface)
  | _ -> Alcotest.fail "a channel was expected"

let only () =
  let t =
    accept
      (cube ^ corner
       ^ "process p = Cube mass 1 [<a, {only top, only [b,a], right, only [b,c]}>. nil]\n\
          process q = Corner at translate (20,0,0) [<a, {only left.top, only q.arm.[a,b]}>. nil]")
  in
  match ((state_leaf t "p").behaviour.term, (state_leaf t "q").behaviour.term) with
  | Behaviour.Open (_, c, _), Behaviour.Open (_, d, _) ->
    let names leaf = List.map (Model.site_name t.model ~leaf:(leaf_index t leaf)) in
    Alcotest.(check strings) "an edge of right is in its closure" [ "p.[a,b]"; "p.top" ] (names "p" c.only);
    Alcotest.(check strings) "listed with its closure" [ "p.right" ] (names "p" c.sites);
    Alcotest.(check int) "right with its edges and corners, and two more" (1 + 4 + 4 + 2) (List.length c.surface);
    Alcotest.(check strings) "of a compound" [ "q.left.top"; "q.arm.[a,b]" ] (names "q" d.surface)
  | _ -> Alcotest.fail "channels were expected"

let definitions () =
  let t =
    accept
      (cube
       ^ "shape Tetra { vertices a (1,1,1) b (1,-1,-1) c (-1,1,-1) d (-1,-1,1) \
          faces x [b,d,c] y [a,c,d] z [a,d,b] w [a,b,c] }\n\
          behaviour Later = <a, {a}>. K behaviour K = <a, {[a,b]}>. Later + eps(2). nil\n\
          process p = Cube mass 1 [K] process q = Cube mass 1 at translate (9,0,0) * scale (1,2,3) [K]\n\
          process r = Tetra mass 1 at translate (0,9,0) [K]\n\
          check k : always behaviour(p) = K and behaviour(r) != Later and K = behaviour(q)")
  in
  let called name =
    match (state_leaf t name).behaviour.term with
    | Behaviour.Call i -> i
    | _ -> Alcotest.fail "a name was expected"
  in
  Alcotest.(check int) "one for each structure" (called "p") (called "q");
  Alcotest.(check bool) "another for another structure" false (Int.equal (called "p") (called "r"));
  Alcotest.(check strings) "names" [ "K"; "K"; "Later"; "Later" ]
    (List.sort String.compare
       (Array.to_list (Array.map (fun (d : Behaviour.definition) -> d.name) t.model.definitions)));
  match (List.hd t.checks).formula with
  | Globally
      ( All, _,
        State
          (And [ And [ Fact (Behaviour (0, k)); Not (Fact (Behaviour (2, l))) ]; Fact (Behaviour (1, k')) ]) ) ->
    Alcotest.(check int) "of p" (called "p") k;
    Alcotest.(check int) "of q" (called "q") k';
    Alcotest.(check string) "of r" "Later" t.model.definitions.(l).name
  | f -> Alcotest.fail (Show.temporal t.model f)

let canonical () =
  let t =
    accept
      (cube ^ "process p = Cube mass 1 [eps(0). omega(a, {top}). rho({<~b, {left}>, <a, {top}>}). eps(1/2). nil]")
  in
  match (state_leaf t "p").behaviour.term with
  | Behaviour.Weak ({ name = "a"; _ }, _, Strong ([ { name = "a"; _ }; { name = "b"; _ } ], _, Delay (d, Nil))) ->
    same_rational "delay" (q 1 2) d
  | _ -> Alcotest.fail "another term was expected"

(* {1 Networks} *)

let chain =
  cube
  ^ "process r = p2 : Cube mass 1 velocity (1,0,0) [nil] <bond, {p2.left, p3.right}> p3 : Cube mass 1 \
     velocity (1,0,0) at translate (-2,0,0) [nil]\n"

let bonds () =
  let t =
    accept
      (chain
       ^ "for i in 1..3 { process c[i] = Cube mass 1 at translate (2*i, 5, 0) [nil] }\n\
          for i in 1..2 { bond <link, {c[i].right, c[i+1].left}> }\n\
          process s = Cube mass 1 velocity (1,0,0) at translate (2,0,0) [nil] bond <x, {s.[a,d], p2.[b,c]}>")
  in
  Alcotest.(check int) "processes" 2 (Array.length t.declared.processes);
  Alcotest.(check int) "leaves" 3 (Array.length (process_of t "p2").leaves);
  Alcotest.(check int) "the chain" 2 (Array.length (process_of t "c[2]").bonds);
  same_vector "velocity" (Vec.of_ints 1 0 0) (process_of t "s").velocity;
  Alcotest.(check int) "well-formed" 0 (List.length (Well_formed.check (standard t.model) t.declared))

let network () =
  let text network =
    chain
    ^ "for i in 1..2 { process g[i] = Cube mass 1 at translate (4*i, 9, 0) [nil] }\n\
       process inside = Cube mass 1 at translate (4, 9, 0) [nil] fixed w = Cube at translate (0,0,-9)\n" ^ network
  in
  let names n = leaf_names (accept (text n)) in
  Alcotest.(check strings) "a process and a family" [ "p2"; "p3"; "g[1]"; "g[2]" ] (names "network r || g");
  Alcotest.(check strings) "one of a family" [ "g[2]"; "inside"; "w" ] (names "network g[2] || inside || w");
  Alcotest.(check strings) "none" [] (names "network nil");
  Alcotest.(check strings) "without what is bound" [ "w" ]
    (names "process u = Cube mass 1 velocity (1,0,0) at translate (2,0,0) [nil] \
            bond <x, {u.left, p2.right}> network w");
  match elaborate (text "") with
  | Ok _ -> Alcotest.fail "everything together interpenetrates"
  | Error ds -> Alcotest.(check strings) "all" [ "SC0403" ] (List.map (fun (d : Diag.t) -> d.code) ds)

let fixed () =
  let t =
    accept
      (cube ^ "fixed w = Cube scaled (9,9,1) [<a, {top}>. nil] process p = Cube mass 2 \
               at translate (0,0,2) [nil] bond <a, {w.top, p.bottom}>")
  in
  Alcotest.(check bool) "fixed" true (leaf t "w").fixed;
  Alcotest.(check bool) "no mass" true (Option.is_none (State.mass t.model (process_of t "p")));
  Alcotest.(check int) "well-formed" 0 (List.length (Well_formed.check (standard t.model) t.declared))

(* {1 Motion} *)

let motion () =
  let t =
    accept
      (chain
       ^ "for i in 1..2 { process g[i] = Cube mass 1 at translate (4*i, 9, 0) [nil] } \
          process p = Cube mass 1 at translate (0,0,9) [nil]\n\
          fixed w = Cube at translate (0,0,-9)\n\
          motion g[2] = (vx - 2*3*dt, vy, if z > 0 and not (x < 1 or false) then round(vz, 1/8) else -mass)\n\
          motion r = (1/2, 0, 0) motion p3 = (1,0,0) motion (vx, vy, vz - 10*dt) motion g = inertial")
  in
  let law name = (leaf t name).law in
  let is_inertial name = Law.is_inertial (law name) in
  Alcotest.(check bool) "the family's" true (is_inertial "g[1]");
  Alcotest.(check bool) "none for a wall" true (is_inertial "w");
  (match law "g[2]" with
   | Gives
       { velocity =
           ( Sub (Var Vx, Mul (Const six, Var Dt)),
             Var Vy,
             If (And (Compare (Gt, Var Z, Const _), Not (Compare (Lt, Var X, Const _))),
                 Round (Var Vz, Const _), Neg (Var Mass)) );
         spin = None } ->
     same_rational "folded" (q 6 1) six
   | _ -> Alcotest.fail "its own law was expected");
  (match (law "p2", law "p3") with
   | Gives { velocity = Const a, _, _; _ }, Gives { velocity = Const b, _, _; _ } ->
     same_rational "the process's" (q 1 2) a;
     same_rational "the leaf's" (q 1 1) b
   | _ -> Alcotest.fail "constant laws were expected");
  (match law "p" with
   | Gives { velocity = Var Vx, Var Vy, Sub _; _ } -> ()
   | _ -> Alcotest.fail "the general law was expected");
  Alcotest.(check bool) "steered" true t.model.steered;
  Alcotest.(check bool) "no time" false t.model.keeps_time;
  match t.declared.step with
  | Some { phase = Due; _ } -> ()
  | _ -> Alcotest.fail "a steered network begins with a step that is due"

let time () =
  let keeps text = (accept (cube ^ "process p = Cube mass 1 [nil] " ^ text)).model.keeps_time in
  Alcotest.(check bool) "a law" true (keeps "motion (time, 0, 0)");
  Alcotest.(check bool) "a check" true (keeps "check k : always (time > 1 => x(p) = 0)");
  Alcotest.(check bool) "a bound is no time" false (keeps "check k : always x(p) = 0 within 3")

(* {1 Size} *)

(* Long chains of operators, prefixes and lets stay off the stack. *)
let deep () =
  let many n piece = String.concat "" (List.init n (fun _ -> piece)) in
  let t =
    accept
      (cube ^ "process p = Cube mass 1 [nil]\n"
       ^ Printf.sprintf "process d = Cube mass 1 at translate (0,0,50) [%s nil]\n" (many 9_000 "<a, {top}>. ")
       ^ Printf.sprintf "check k : always x(p)%s > 0\n" (many 9_000 " + x(p)")
       ^ "let l0 = x(p)\n"
       ^ String.concat "" (List.init 4_000 (fun i -> Printf.sprintf "let l%d = l%d + 1\n" (i + 1) i))
       ^ "check l : always l4000 > 0")
  in
  Alcotest.(check int) "checks" 2 (List.length t.checks)

(* Ten thousand bodies: quadratic work would show as minutes. *)
let large () =
  let t =
    accept
      (cube
       ^ "for i in 1..100, j in 1..100 { process g[i,j] = Cube mass 1 at translate (2*i, 2*j, 0) [K] }\n\
          behaviour K on Cube = <a, {top}>. K\n\
          for i in 1..100, j in 1..99 { bond <a, {g[i,j].back, g[i,j+1].front}> }\n\
          check k : always forall p in Cube: x(p) >= 0")
  in
  Alcotest.(check int) "leaves" 10_000 (Array.length t.model.leaves);
  Alcotest.(check int) "processes" 100 (Array.length t.declared.processes);
  Alcotest.(check int) "well-formed" 0 (List.length (Well_formed.check (standard t.model) t.declared))

let case name run = Alcotest.test_case name `Quick run

let suite =
  ("terms",
   [
     ("values", [ case "loops" loops; case "overrides" overrides;
                  case "defaults" defaults; case "scopes" scopes ]);
     ( "shapes",
       [
         case "solids" solids;
         case "matrix" matrix;
         case "compound" compound;
         case "velocity of a compound" compound_velocity;
         case "mesh" mesh;
       ] );
     ( "behaviours",
       [
         case "features" features; case "only" only; case "definitions" definitions;
         case "canonical" canonical;
       ] );
     ("networks", [ case "bonds" bonds; case "network" network; case "fixed" fixed ]);
     ("motion", [ case "laws" motion; case "time" time ]);
     ("size", [ case "deep" deep; case "large" large ]);
   ])
