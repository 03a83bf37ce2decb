(* Functions and vectors, families, and modules: what a model with them is, and what is wrong with others. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_property
open Models
open Fault_case

let files list path = Option.to_result ~none:"there is no such file" (List.assoc_opt path list)

(* {1 Functions and vectors} *)

(* What an expression of a parameter is worth. *)
let worth (expression, expected) =
  Alcotest.test_case expression `Quick (fun () ->
      let t = accept ("let up = (0, 0, 1) let v = (1, 2, 3) param n = 7 param k = " ^ expression) in
      Alcotest.(check string) expression expected (Rat.to_string (List.assoc "k" t.parameters)))

let numbers =
  [
    ("min(3, 1, 2)", "1"); ("max(n, 7/2)", "7"); ("min(n)", "7"); ("abs(-3/2)", "3/2"); ("abs(2)", "2");
    ("sign(-5) + 10*sign(0) + 100*sign(1/9)", "99"); ("floor(7/2)", "3"); ("floor(-7/2)", "-4");
    ("ceil(7/2)", "4"); ("ceil(-7/2)", "-3"); ("floor(3)", "3"); ("ceil(-1/2)", "0"); ("floor(1/2)", "0");
    ("7 mod 3", "1"); ("-7 mod 3", "2"); ("mod(7, -3)", "-2"); ("7/2 mod 2", "3/2"); ("2*7 mod 4", "2");
    ("dot(v, v)", "14"); ("dot(cross(v, up), v)", "0"); ("dot(cross(v, up), (1, 0, 0))", "2");
    ("v.x + 10*v.y + 100*v.z", "321"); ("dot(v + up, (1, 1, 1))", "7"); ("dot(v - 2*up, (1, 1, 1))", "4");
    ("dot(-v/2, (1, 1, 1))", "-3"); ("dot(if n > 3 then v else up, up)", "3");
    ("if v = (1, 2, 3) and v != up then 1 else 0", "1"); ("cross(v, up).x", "2"); ("cross(v, up).y*2", "-2");
    ("(v + 2*up).z", "5"); ("(4, 5, 6).y", "5"); ("-(if n > 3 then v else up).y", "-2");
  ]

let law text =
  let t = accept (cube ^ "let down = (0, 0, -1) process p = Cube mass 2 velocity (1, 0, 0) [nil] " ^ text) in
  t.model.leaves.(0).law

(* The velocity that a law gives at a place, with this velocity, at a time. *)
let steers (text, at, expected) =
  Alcotest.test_case text `Quick (fun () ->
      let env : Law.variable -> Rat.t = function
        | X | Vx -> Rat.of_literal at |> Result.get_ok
        | Mass -> Rat.of_int 2
        | Y | Z | Vy | Vz | Wx | Wy | Wz | Time | Dt -> Rat.one
      in
      let value e = Rat.to_string (Result.get_ok (Law.eval env e)) in
      match law text with
      | Inertial | Choose _ -> Alcotest.fail "no such law"
      | Gives { velocity = x, y, z; _ } ->
        Alcotest.(check string) text expected (String.concat " " [ value x; value y; value z ]))

let laws =
  [
    ("motion p = down*mass", "1", "0 0 -2"); ("motion p = if x > 0 then down else -down", "1", "0 0 -1");
    ("motion if x > 0 then down else -down", "-1", "0 0 1"); ("motion (down)", "0", "0 0 -1");
    ("motion p = (min(x, 2), max(x, 2), abs(x))", "-3", "-3 2 3");
    ("motion p = (floor(x), ceil(x), sign(x))", "-7/2", "-4 -3 -1");
    ("motion p = (floor(x), ceil(x), x mod 3)", "7/2", "3 4 1/2");
    ("motion p = (floor(x), ceil(x), x mod 3)", "-3", "-3 -3 0");
    ("motion p = (vx, vy, vz)/2 + cross(down, (x, 0, 0))", "4", "2 -7/2 1/2");
    ("motion p = (cross(down, (x, 0, 0)).y, (vx*down).z, 0)", "4", "-4 -4 0");
  ]

let formula text = accept (cube ^ "let v = (1, 2, 3) process p = Cube mass 1 [nil] check c : " ^ text)

let formulas () =
  ignore (formula "always max(x(p), y(p), 0) = abs(z(p)) and sign(vx(p)) <= 0");
  ignore (formula "always dot((x(p), y(p), z(p)), v) = 0 and (x(p), y(p), z(p)) = (0, 0, 0)");
  ignore (formula "always cross((x(p), y(p), z(p)), v).x = 0 and (v + (x(p), 0, 0)).y = 2");
  ignore (formula "always forall i in 1..4 if i mod 2 = 0: x(p) < i");
  let counted = formula "always count(i in 1..4 if i != 2: x(p) < i) = 3" in
  match (List.hd counted.checks).formula with
  | Globally (_, _, State (Compare (_, Count ps, _))) -> Alcotest.(check int) "instances" 3 (List.length ps)
  | _ -> Alcotest.fail "not a count"

let of_functions =
  let formula text = cube ^ "process p = Cube mass 1 [nil] check c : always " ^ text in
  [
    case "a function that constants do not have" "SC0201" "foo" ~says:"abs, ceil, cross, dot, floor, max, min"
      "param n = foo(1)";
    case "a misspelt function" "SC0201" "flor" ~says:"did you mean `floor`" "param n = flor(1)";
    case "a function that laws do not have" "SC0201" "sin" ~says:"those that can stand here are"
      "motion (sin(x), 0, 0)";
    case "a function that formulas do not have" "SC0201" "sqrt" ~says:"touching" (formula "sqrt(x(p)) = 1");
    case "floor of what moves" "SC0205" "floor(x(p))" ~says:"of what changes" (formula "floor(x(p)) = 1");
    case "mod of what moves" "SC0205" "x(p) mod 2" ~says:"of what changes" (formula "x(p) mod 2 = 1");
    case "mod zero" "SC0207" "3 mod 0" "param n = 3 mod 0";
    case "a sum of a number and a vector" "SC0205" "1 + (1, 2, 3)" ~says:"a number and a vector"
      "let n = 1 + (1, 2, 3) param m = n.x";
    case "a product of vectors" "SC0205" "v*v" ~says:"`dot(v, w)`" "let v = (1, 2, 3) param m = v*v";
    case "a vector for a number" "SC0205" "v" ~says:"this is a vector" "let v = (1, 2, 3) param m = v";
    case "a number for a vector" "SC0205" "2" ~says:"this is a number"
      (cube ^ "process p = Cube mass 1 velocity 2 [nil]");
    case "a component that there is not" "SC0201" "w" ~says:"x, y and z" "let v = (1, 2, 3) param m = v.w";
    case "a component of a function that there is not" "SC0201" "w" ~says:"x, y and z"
      "let v = (1, 2, 3) param m = cross(v, v).w";
    case "a component of a number" "SC0205" "dot(v, v)" ~says:"a vector is expected"
      "let v = (1, 2, 3) param m = dot(v, v).x";
    case "abs of two" "SC0206" "abs(1, 2)" "param m = abs(1, 2)";
    case "dot of numbers" "SC0206" "dot(1, 2)" ~says:"two vectors" "param m = dot(1, 2)";
    case "branches of two kinds" "SC0205" "1" ~says:"a vector and a number"
      "param m = if 1 < 2 then (1, 2, 3) else 1";
    case "functions within functions" "SC0111"
      (String.concat "" (List.init 40 (fun _ -> "min(")) ^ "x" ^ String.concat "" (List.init 40 (fun _ ->
           ", vx)")))
      ~says:"terms"
      ("motion (" ^ String.concat "" (List.init 40 (fun _ -> "min(")) ^ "x"
       ^ String.concat "" (List.init 40 (fun _ -> ", vx)")) ^ ", 0, 0)");
  ]

(* {1 Families} *)

let definitions (t : Scc_elaborate.Elaborate.t) =
  List.sort String.compare
    (Array.to_list (Array.map (fun (d : Behaviour.definition) -> d.name) t.model.definitions))

let names = Alcotest.(check (list string))
let on behaviour = cube ^ "process p = Cube mass 1 [" ^ behaviour ^ "] "

let behaviours () =
  let count = "behaviour C[i] = eps(i). C[i - 1] behaviour C[0] = nil " in
  names "down to the special one" [ "C[0]"; "C[1]"; "C[2]" ] (definitions (accept (count ^ on "C[2]")));
  names "by a loop" [ "K[2]"; "K[3]" ]
    (definitions (accept ("for i in 1..4 { behaviour K[i] = eps(1). nil } " ^ on "K[2] + K[1 + 2]")));
  let lock = "behaviour L(a, f, K, t) = <a, {f}>. eps(t). D(K) where t2 = t/2 behaviour D(K) = eps(1). K \
              behaviour E = nil " in
  let t = accept (lock ^ on "L(dock, left, E, 1/2)" ^ "check c : possibly behaviour(p) = D(E) and \
                                                       offers(p, dock)") in
  names "names and numbers" [ "D(E)"; "E"; "L(dock,left,E,1/2)" ] (definitions t);
  names "two indices" [ "T[1,2]" ] (definitions (accept ("behaviour T[i, j] = eps(i*j). nil " ^ on "T[1, 2]")))

let templates (t : Scc_elaborate.Elaborate.t) =
  Array.to_list (Array.map (fun (l : Model.leaf) -> l.template) t.model.leaves)

let shapes () =
  let t =
    accept
      "shape B(a, b) = box(a, b, h) where h = a*b compound D(w) { part l : B(w, 1) mass 1 part r : B(w, 1) mass 1 \
       at translate (w, 0, 0) glue l.right ~ r.left } \
       process p = B(2, 3) mass 1 [nil] process q = B(1 + 1, 3) mass 1 at translate (9, 0, 0) [nil] \
       process r = D(2) at translate (0, 20, 0) [nil] check c : always forall b in B: x(b) < 99 \
       check d : always forall b in B(2, 3): x(b) < 99"
  in
  names "labels" [ "B(2,3)"; "B(2,3)"; "D(2)" ] (templates t);
  let v = (t.model.leaves.(0)).parts.(0).solid.Scc_geometry.Solid.volume in
  Alcotest.(check string) "volume" "36" (Rat.to_string v);
  Alcotest.(check int) "one solid for both" t.model.leaves.(0).parts.(0).solid.id
    t.model.leaves.(1).parts.(0).solid.id

let texts () =
  let t =
    accept
      ("for i in 1..4 if i mod 2 = 0 { let j = i + 1 process m[i] = box(1, 1, 1) mass 1 at translate (3*j, \
        0, 0) [nil] } \
        for i in 1..1 { let k = i + 1 check near : always distance2(m[i + 1], m[2*k]) <= k + 6 and \
        forall i in 1..2: x(m[2*i]) > 0 }")
  in
  names "bodies" [ "m[2]"; "m[4]" ] (Array.to_list (Array.map (fun (l : Model.leaf) -> l.name) t.model.leaves));
  names "text" [ "always distance2(m[2], m[4]) <= 2 + 6 and (forall i in 1..2: x(m[2*i]) > 0)" ]
    (List.map (fun (k : Property.check) -> k.text) t.checks)

let of_families =
  [
    case "an instance that there is not" "SC0201" "K" ~says:"declared is `K[1]`, `K[2]`"
      ("for i in 1..2 { behaviour K[i] = nil } " ^ on "K[3]");
    case "a family without its indices" "SC0201" "K" ~says:"`K[_]`" ("behaviour K[i] = nil " ^ on "K");
    case "another number of parameters" "SC0201" "K" ~says:"`K(_,_)`" ("behaviour K(a, b) = nil " ^ on "K(1)");
    case "a parameter twice" "SC0202" "a" "behaviour K(a, a) = nil";
    case "an index that is no integer" "SC0204" "1/2" ("behaviour K[i] = nil " ^ on "K[1/2]");
    case "a behaviour twice in a loop" "SC0202" "K" "for i in 1..2 { behaviour K = nil }";
    case "a family without end" "SC0111" "K" ~says:"has no end" ("behaviour K[i] = eps(1). K[i + 1] " ^ on "K[1]");
    case "a recursion of an instance" "SC0501" "K" ~says:"`K[1]`" ("behaviour K[i] = K[i] " ^ on "K[1]");
    case "shapes without end" "SC0111" "S" "shape S(a) = S(a + 1) scaled (1, 1, 1) process p = S(1) mass 1 [nil]";
    case "a name for a number" "SC0210" "t" ~says:"stands for the name `dock`"
      ("behaviour K(t) = eps(t). nil " ^ on "K(dock)");
    case "a family that nothing uses" "SC0211" "K" ("behaviour K[i] = nil " ^ on "nil");
    case "shapes that nothing uses" "SC0211" "B" ("shape B(a) = box(a, a, a) " ^ on "nil");
    case "a range that is too long" "SC0111" "10000000"
      (on "nil" ^ "check c : always forall i in 1..10000000 if i < 0: true");
    case "a condition that is a number" "SC0205" "i" ("for i in 1..2 if i { let x = 1 } " ^ on "nil");
    case "corners" "SC0208" "prism" ~says:"from 3 to 256" "process p = prism(2, 1, 1) mass 1 [nil]";
    case "no lengths" "SC0206" "box" "process p = box(1, 2) mass 1 [nil]";
    case "a negative length" "SC0208" "box" "process p = box(1, 2, -1) mass 1 [nil]";
    case "a flat hull" "SC0301" "hull { a (0, 0, 0) b (1, 0, 0) c (0, 1, 0) d (1, 1, 0) }"
      "shape T = hull { a (0, 0, 0) b (1, 0, 0) c (0, 1, 0) d (1, 1, 0) }";
  ]

let polyhedron text =
  let t = accept ("shape S = " ^ text ^ " process p = S mass 1 [nil]") in
  snd (List.hd t.templates)

let hulls () =
  let p =
    polyhedron
      "hull { a (0,0,0) b (2,0,0) c (2,2,0) d (0,2,0) m (1,1,0) e (0,0,2) f1 (2,0,2) g (2,2,2) h (0,2,2) i \
       (1,1,1) \
       j (1,0,0) }"
  in
  names "corners" [ "a"; "b"; "c"; "d"; "e"; "f1"; "g"; "h" ] (Array.to_list (Array.map fst p.vertices));
  names "faces" [ "f2"; "f3"; "f4"; "f5"; "f6"; "f7" ] (Array.to_list (Array.map fst p.faces))

let counts (text, corners, faces) =
  Alcotest.test_case text `Quick (fun () ->
      let p = polyhedron text in
      Alcotest.(check (pair int int)) text (corners, faces) (Array.length p.vertices, Array.length p.faces))

let solids =
  [
    ("box(1, 2, 3)", 8, 6); ("box((1, 2, 3))", 8, 6); ("prism(3, 1, 1)", 6, 5); ("prism(7, 2, 1)", 14, 9);
    ("prism(256, 1, 1)", 512, 258); ("antiprism(3, 1, 1)", 6, 8); ("antiprism(5, 1, 2)", 10, 12);
    ("antiprism(256, 1, 1)", 512, 514); ("pyramid(4, 1, 1)", 5, 5); ("pyramid(6, 1, 3)", 7, 7);
  ]

(* Every point is on the circle, and near enough to where it should be; quarters are exact. *)
let circles () =
  let check n =
    for k = 0 to n - 1 do
      let x, y = Scc_elaborate.Solids.on_circle n k in
      Alcotest.(check string) "on the circle" "1" (Rat.to_string (Rat.add (Rat.mul x x) (Rat.mul y y)));
      let angle = 2. *. Float.pi *. float_of_int k /. float_of_int n in
      let off = Float.hypot (Rat.to_float x -. cos angle) (Rat.to_float y -. sin angle) in
      if off > 1. /. 1024. then Alcotest.failf "%d of %d is off by %g" k n off
    done
  in
  List.iter check ([ 61; 64; 255; 256 ] @ List.init 20 (fun i -> i + 3));
  let square = List.init 4 (fun k -> Scc_elaborate.Solids.on_circle 4 k) in
  names "a square" [ "1 0"; "0 1"; "-1 0"; "0 -1" ]
    (List.map (fun (x, y) -> Rat.to_string x ^ " " ^ Rat.to_string y) square)

(* {1 Modules} *)

let shapes_file = "param a = 2 let v = (a, 0, 0) shape Cube = box(a, a, a) behaviour Wait[i] = eps(i). nil "

let with_files list text () = ignore (accept ~read_file:(files list) text)

let imports () =
  let t =
    accept
      ~overrides:[ ("shapes.a", Rat.of_int 3) ]
      ~read_file:
        (files
           [
             ("parts/shapes.sc", shapes_file);
             ( "parts/keys.sc",
               "import \"shapes.sc\" (Cube as C) shape K = C scaled (2, 1, 1) behaviour Late(t) = eps(t). nil \
                shape B(a) = box(a, a, a)" );
           ])
      "import \"parts/shapes.sc\" import \"parts/shapes.sc\" (Cube, v as w) import \"parts/keys.sc\" as k \
       process p = shapes.Cube mass shapes.a velocity w [shapes.Wait[2]] \
       process q = Cube mass shapes.v.x at translate (9, 0, 0) [nil] \
       process r = k.K mass 1 at translate (0, 9, 0) [nil] \
       check c : possibly behaviour(p) = shapes.Wait[2] and behaviour(s) = k.Late(1) \
       check d : always forall b in shapes.Cube: x(b) < 99 \
       check e : always forall b in k.B(1): x(b) < 99 process s = k.B(1) mass 1 at translate (0, 0, 9) [k.Late(1)]"
  in
  names "labels" [ "shapes.Cube"; "shapes.Cube"; "keys.K"; "keys.B(1)" ] (templates t);
  names "parameters" [ "shapes.a" ] (List.map fst t.parameters);
  names "definitions" [ "keys.Late(1)"; "shapes.Wait[2]" ] (definitions t);
  Alcotest.(check string) "by -D" "3" (Rat.to_string t.model.leaves.(1).mass);
  names "no warnings" [] (List.map (fun (d : Diag.t) -> d.message) t.warnings)

(* By each of its names. *)
let parameters () =
  let value name =
    let t =
      accept
        ~overrides:[ (name, Rat.of_int 5) ]
        ~read_file:(files [ ("d/m.sc", "param a = 2"); ("k.sc", "import \"d/m.sc\" param b = m.a") ])
        "import \"k.sc\" import \"d/m.sc\" as w import \"d/m.sc\" (a as c) param e = k.b + 10*w.a + 100*c"
    in
    Rat.to_string (List.assoc "e" t.parameters)
  in
  names "values" [ "555"; "555"; "555" ] (List.map value [ "m.a"; "w.a"; "c" ])

let library () =
  let t =
    accept
      "import <solids> process a = solids.Cube(1) mass 1 [nil] process b = solids.Plank(1, 2, 3) mass 1 at \
       translate (9, 0, 0) \
       [nil] process c = solids.Chamfered(2, 1/4) mass 1 at translate (18, 0, 0) [nil] process d = \
       solids.Wedge(1, 2, 3) mass 1 \
       at translate (27, 0, 0) [nil] process e = solids.Tetrahedron(1) mass 1 at translate (36, 0, 0) \
       [nil] process f = \
       solids.Octahedron(1) mass 1 at translate (45, 0, 0) [nil] process g = solids.Dodecahedron(1) mass 1 \
       at translate (54, 0, \
       0) [nil] process h = solids.Icosahedron(1) mass 1 at translate (63, 0, 0) [nil] fixed i = \
       solids.Room(200, 200, 200, 1)"
  in
  let faces (l : Model.leaf) = Array.length l.parts.(0).solid.Scc_geometry.Solid.polyhedron.faces in
  Alcotest.(check (list int)) "faces" [ 6; 6; 26; 5; 4; 8; 12; 20; 6 ] (Array.to_list (Array.map faces
                                                                                         t.model.leaves));
  let centred (l : Model.leaf) =
    Array.length l.parts > 1 || Vec.is_zero l.parts.(0).solid.Scc_geometry.Solid.centroid
  in
  Alcotest.(check (list bool)) "centred" (List.init 9 (fun _ -> true))
    (Array.to_list (Array.map centred t.model.leaves))

(* The code, the file and the words of the first fault. *)
let refused name list text ~code ~file ~says =
  Alcotest.test_case name `Quick (fun () ->
      match elaborate ~read_file:(files list) text with
      | Ok _ -> Alcotest.fail "accepted"
      | Error ds ->
        let fits (d : Diag.t) =
          String.equal d.code code && String.equal d.span.file file
          && contains (d.message ^ Option.value ~default:"" d.hint) says
        in
        if not (List.exists fits ds) then
          Alcotest.failf "%s" (String.concat "" (List.map (show text) ds)))

let faults =
  let cube = "process p = m.Cube mass 1 [nil]" in
  [
    refused "no such file" [] ("import \"m.sc\" " ^ cube) ~code:"SC0101" ~file:"test.sc" ~says:"no such file";
    refused "a fault in the file" [ ("m.sc", "shape Cube = box(1, 1)") ] ("import \"m.sc\" " ^ cube) ~code:"SC0206"
      ~file:"m.sc" ~says:"three lengths";
    refused "text that does not fit" [ ("m.sc", "shape Cube box") ] ("import \"m.sc\" " ^ cube) ~code:"SC0110"
      ~file:"m.sc" ~says:"box";
    refused "a circle of two" [ ("d/m.sc", "import \"../n.sc\""); ("n.sc", "import \"./d/m.sc\"") ]
      "import \"d/m.sc\"" ~code:"SC0216" ~file:"n.sc" ~says:"`d/m.sc` imports itself, by `n.sc`";
    refused "the model itself" [ ("m.sc", "import \"test.sc\"") ] "import \"m.sc\"" ~code:"SC0216"
      ~file:"m.sc" ~says:"";
    refused "bodies" [ ("m.sc", "shape Cube = box(1, 1, 1) process p = Cube mass 1 [nil]") ] ("import \
                                                                                               \"m.sc\" " ^ cube)
      ~code:"SC0210" ~file:"m.sc" ~says:"cannot be imported";
    refused "no such name" [ ("m.sc", shapes_file) ] "import \"m.sc\" (Cub)" ~code:"SC0201" ~file:"test.sc"
      ~says:"did you mean `Cube`";
    refused "no such shape" [ ("m.sc", shapes_file) ] "import \"m.sc\" process p = m.Cub mass 1 [nil]"
      ~code:"SC0201"
      ~file:"test.sc" ~says:"did you mean `m.Cube`";
    refused "no such value" [ ("m.sc", shapes_file) ] "import \"m.sc\" param k = m.b" ~code:"SC0201"
      ~file:"test.sc"
      ~says:"has no value `b`";
    refused "no such import" [] "process p = n.Cube mass 1 [nil]" ~code:"SC0201" ~file:"test.sc"
      ~says:"no import is called";
    refused "a name twice" [ ("m.sc", shapes_file) ] "import \"m.sc\" (Cube) shape Cube = box(1, 1, 1)"
      ~code:"SC0202"
      ~file:"test.sc" ~says:"that of an import";
    refused "a qualifier twice" [ ("m.sc", shapes_file); ("n.sc", "param b = 1") ] "import \"m.sc\" import \
                                                                                    \"n.sc\" as m"
      ~code:"SC0202" ~file:"test.sc" ~says:"taken";
    refused "a file name that is no name" [ ("1.sc", shapes_file) ] "import \"1.sc\"" ~code:"SC0208"
      ~file:"test.sc"
      ~says:"as m";
    refused "no such library" [] "import <solid>" ~code:"SC0201" ~file:"test.sc" ~says:"did you mean `solids`";
    refused "a state of an import for a value" [ ("m.sc", shapes_file) ]
      ("import \"m.sc\" process p = m.Cube mass 1 [nil] check c : always m.Wait(2) = 1") ~code:"SC0205"
      ~file:"test.sc" ~says:"`behaviour(p) = m.K(a)`";
    refused "a family that nothing uses" [ ("m.sc", "shape Cube = box(1, 1, 1) behaviour K(t) = eps(t + u). nil") ]
      ("import \"m.sc\" " ^ cube) ~code:"SC0201" ~file:"m.sc" ~says:"`u`";
    refused "what an import imports" [ ("m.sc", "import \"n.sc\""); ("n.sc", shapes_file) ]
      "import \"m.sc\" process p = m.Cube mass 1 [nil]" ~code:"SC0201" ~file:"test.sc" ~says:"m.Cube";
  ]

let diamond =
  with_files
    [
      ("a.sc", "import \"c.sc\" shape A = c.Cube"); ("b.sc", "import \"c.sc\" as other shape B = other.Cube");
      ("c.sc", shapes_file);
    ]
    "import \"a.sc\" import \"b.sc\" process p = a.A mass 1 [nil] process q = b.B mass 1 at translate (9, \
     0, 0) [nil]"

let suite =
  let test = Alcotest.test_case in
  ("the language",
   [
     ("numbers", List.map worth numbers); ("laws", List.map steers laws);
     ("formulas", [ test "functions and ranges" `Quick formulas ]); ("faults of functions", cases of_functions);
     ( "families",
       [
         test "of behaviours" `Quick behaviours; test "of shapes" `Quick shapes; test "texts of checks"
           `Quick texts;
       ] );
     ("faults of families", cases of_families);
     ("solids", test "hulls" `Quick hulls :: test "circles" `Slow circles :: List.map counts solids);
     ( "modules",
       [
         test "imports" `Quick imports; test "values for parameters" `Quick parameters;
         test "the library" `Quick library; test "a diamond" `Quick diamond;
       ] );
     ("faults of modules", faults);
   ])
