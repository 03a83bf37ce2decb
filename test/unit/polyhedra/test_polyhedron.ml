open Scc_exact
open Scc_geometry

(* {1 The cube of Figure 4} *)

let corners d =
  [|
    ("a", (-1, -1, -1)); ("b", (1, -1, -1)); ("c", (1, 1, -1)); ("d", (-1, 1, -1));
    ("e", (-1, -1, 1)); ("f", (1, -1, 1)); ("g", (1, 1, 1)); ("h", (-1, 1, 1));
  |]
  |> Array.map (fun (name, (x, y, z)) -> (name, Vec.of_ints (x + d) y z))

let sides =
  [|
    ("bottom", [| 0; 3; 2; 1 |]); ("top", [| 4; 5; 6; 7 |]); ("left", [| 0; 4; 7; 3 |]);
    ("right", [| 1; 2; 6; 5 |]); ("front", [| 0; 1; 5; 4 |]); ("back", [| 3; 7; 6; 2 |]);
  |]

let set vertices faces = { Polyhedron.ifs_vertices = vertices; ifs_faces = faces }
let reverse a = Array.of_list (List.rev (Array.to_list a))
let turn (name, face) = (name, reverse face)
let replace a i x = Array.mapi (fun j y -> if i = j then x else y) a

let cube =
  match Polyhedron.of_ifs (set (corners 0) sides) with
  | Ok p -> p
  | Error _ -> Alcotest.fail "the cube is refused"

let print_fault f =
  let name i = string_of_int i in
  let cure = Option.value ~default:"" (Polyhedron_fault.hint ~vertex:name ~face:name f) in
  Polyhedron_fault.(kind f ^ ": " ^ message ~vertex:name ~face:name f ^ cure)

let faults_of vertices faces =
  match Polyhedron.of_ifs (set vertices faces) with
  | Ok _ -> []
  | Error found -> found

let expect name vertices faces expected =
  let print = List.map print_fault in
  Alcotest.(check (list string)) name (print expected) (print (faults_of vertices faces))

(* {1 Definitions 4.1 and 4.2} *)

let test_rotation () =
  let same = Polyhedron.rotation_equivalent in
  let face = [| 0; 1; 2; 3 |] in
  let check name expected other = Alcotest.(check bool) name expected (same face other) in
  check "itself" true face;
  check "by one place, as in the paper" true [| 3; 0; 1; 2 |];
  check "by two places" true [| 2; 3; 0; 1 |];
  check "by three places" true [| 1; 2; 3; 0 |];
  check "reversed" false [| 3; 2; 1; 0 |];
  check "shorter" false [| 0; 1; 2 |];
  check "another" false [| 0; 1; 2; 4 |]

let print_feature f = Polyhedron.feature_name cube f
let print_features = List.map print_feature

let get what = function
  | Some x -> x
  | None -> Alcotest.fail (what ^ " is not found")

let vertex name = Feature.Vertex (get name (Polyhedron.find_vertex cube name))
let face name = Feature.Face (get name (Polyhedron.find_face cube name))

let edge v w =
  let index name = get name (Polyhedron.find_vertex cube name) in
  Feature.Edge (get (v ^ w) (Polyhedron.find_edge cube (index v) (index w)))

let test_downgrade () =
  let check name expected f =
    let sorted = List.sort Feature.compare expected in
    Alcotest.(check (list string)) name (print_features sorted) (print_features (Polyhedron.downgrade cube f))
  in
  check "of a vertex" [] (vertex "a");
  check "of an edge" [ vertex "a"; vertex "b" ] (edge "a" "b");
  check "of a face" [ edge "a" "b"; edge "b" "c"; edge "c" "d"; edge "d" "a" ] (face "bottom")

let test_closure () =
  let closure features = Polyhedron.closure cube features in
  let sides = [ edge "a" "b"; edge "b" "c"; edge "c" "d"; edge "d" "a" ] in
  let ends = List.map vertex [ "a"; "b"; "c"; "d" ] in
  let check name expected found =
    let sorted = List.sort Feature.compare expected in
    Alcotest.(check (list string)) name (print_features sorted) (print_features found)
  in
  check "of a face and a vertex of it, as in the paper" ((face "bottom" :: sides) @ ends)
    (closure [ face "bottom"; vertex "b" ]);
  check "of a vertex" [ vertex "g" ] (closure [ vertex "g"; vertex "g" ]);
  let all = closure (List.map face [ "bottom"; "top"; "left"; "right"; "front"; "back" ]) in
  Alcotest.(check int) "of all faces: a shared edge once (D-9)" 26 (List.length all);
  check "is idempotent" all (closure all)

(* {1 I-1, names} *)

let test_edges () =
  Alcotest.(check int) "twelve edges" 12 (Array.length cube.edges);
  Alcotest.(check string) "in either order" (print_feature (edge "a" "b")) (print_feature (edge "b" "a"));
  Alcotest.(check (option int)) "no diagonal" None (Polyhedron.find_edge cube 0 2);
  Array.iteri
    (fun i (v, w) ->
       Alcotest.(check (option int)) "found by its ends" (Some i) (Polyhedron.find_edge cube w v))
    cube.edges;
  let paper = Definition_4_3.check (Polyhedron.to_ifs cube) in
  Alcotest.(check int) "8 - 12 + 6" 2 (Definition_4_3.euler paper);
  Alcotest.(check int) "8 - 24 + 6, as printed" (-10) (Definition_4_3.euler_ordered paper)

let test_names () =
  Alcotest.(check string) "vertex" "a" (Polyhedron.feature_name cube (vertex "a"));
  Alcotest.(check string) "edge" "[a,b]" (Polyhedron.feature_name cube (edge "b" "a"));
  Alcotest.(check string) "face" "top" (Polyhedron.feature_name cube (face "top"));
  Alcotest.(check (option int)) "cycle" (Some 1) (Polyhedron.find_cycle cube [| 6; 7; 4; 5 |]);
  Alcotest.(check (option int)) "reversed cycle" None (Polyhedron.find_cycle cube [| 7; 6; 5; 4 |]);
  Alcotest.(check (option int)) "no vertex" None (Polyhedron.find_vertex cube "z")

let test_transform () =
  let m = Mat.make (Vec.of_ints 2 1 0) (Vec.of_ints 0 1 3) (Vec.of_ints 0 0 1) in
  let image = Polyhedron.transform m cube in
  Alcotest.(check bool) "is accepted as it is" true
    (match Polyhedron.of_ifs (Polyhedron.to_ifs image) with
     | Ok p -> Polyhedron.equal p image
     | Error _ -> false);
  Alcotest.(check bool) "is another" false (Polyhedron.equal cube image)

(* {1 Definition 4.3: faults, the most telling first} *)

(* What the reverse of a face should have been, from the first corner of the reverse on. *)
let from_last face =
  let n = Array.length face in
  Array.init n (fun i -> face.((i + n - 1) mod n))

let test_faults () =
  let v = corners 0 in
  expect "the cube" v sides [];
  expect "inside out" v (Array.map turn sides) [ Inward ];
  expect "one face turned" v (replace sides 2 (turn sides.(2))) [ Turned_face (2, from_last (snd sides.(2))) ];
  let crossed = replace sides 1 ("top", [| 4; 6; 5; 7 |]) in
  let top = Polyhedron_fault.Self_crossing (1, Some [| 4; 5; 6; 7 |]) in
  expect "one face out of order" v crossed [ top ];
  expect "all inside out, and one out of order" v
    (Array.map turn crossed)
    [ Self_crossing (1, Some [| 7; 6; 5; 4 |]) ];
  expect "two faces out of order" v
    (replace crossed 2 ("left", [| 0; 4; 3; 7 |]))
    [ top; Self_crossing (2, Some [| 0; 4; 7; 3 |]) ];
  expect "one face out of order, and no floor" v
    (Array.of_list (List.tl (Array.to_list crossed)))
    [ Self_crossing (0, Some [| 4; 5; 6; 7 |]); Open_edge (1, 3, 0); Open_edge (2, 1, 2); Open_edge (3, 0, 1);
      Open_edge (4, 2, 3) ];
  expect "one face turned, and no lid" v
    (Array.of_list (List.filter (fun (n, _) -> n <> "top") (Array.to_list (replace sides 2 (turn sides.(2))))))
    [ Turned_face (1, from_last (snd sides.(2))); Open_edge (1, 7, 4); Open_edge (2, 6, 5); Open_edge (3, 5, 4);
      Open_edge (4, 7, 6) ];
  let other = Array.map (fun (n, f) -> ("x" ^ n, Array.map (fun i -> i + 8) f)) sides in
  let names = Array.map (fun (n, p) -> ("x" ^ n, p)) (corners 5) in
  expect "two cubes" (Array.append v names) (Array.append sides other) [ Separate_solids (0, 6) ];
  expect "no lid" v
    (Array.of_list (List.filter (fun (n, _) -> n <> "top") (Array.to_list sides)))
    [ Open_edge (1, 4, 7); Open_edge (2, 6, 5); Open_edge (3, 5, 4); Open_edge (4, 7, 6) ];
  expect "a corner pulled away" (replace v 6 ("g", Vec.of_ints 2 3 4)) sides
    [ Off_plane (1, 6); Off_plane (3, 6); Off_plane (5, 6) ];
  expect "an index out of range" v (replace sides 1 ("top", [| 4; 5; 6; 8 |])) [ Bad_vertex_index (1, 8) ];
  expect "a negative index" v (replace sides 1 ("top", [| 4; 5; 6; -1 |])) [ Bad_vertex_index (1, -1) ];
  expect "two corners" v (replace sides 1 ("top", [| 4; 5 |])) [ Short_face 1 ];
  expect "no corner" v (replace sides 1 ("top", [||])) [ Short_face 1 ];
  expect "nothing" [||] [||] [ No_faces ];
  expect "a corner twice running" v (replace sides 1 ("top", [| 4; 4; 5; 6; 7 |]))
    [ Degenerate_face (1, 4) ]

let test_flat () =
  let v = [| ("a", Vec.zero); ("b", Vec.of_ints 1 0 0); ("c", Vec.of_ints 0 1 0) |] in
  expect "two sides" v [| ("x", [| 0; 1; 2 |]); ("y", [| 2; 1; 0 |]) |] [ Flat 0 ];
  expect "one side" v
    [| ("x", [| 0; 1; 2 |]) |]
    [ Open_edge (0, 0, 1); Open_edge (0, 1, 2); Open_edge (0, 2, 0) ]

(* D-6: tuples that repeat a vertex. *)
let test_degenerate () =
  let first name vertices faces kind =
    match faults_of vertices faces with
    | f :: _ -> Alcotest.(check string) name kind (Polyhedron_fault.kind f)
    | [] -> Alcotest.fail (name ^ " is accepted")
  in
  first "there and back" (corners 0) (replace sides 1 ("top", [| 4; 5; 4 |])) "degenerate-face";
  first "twice round" (corners 0) (replace sides 1 ("top", [| 4; 5; 6; 7; 4; 5; 6; 7 |])) "self-crossing"

(* D-8: with coplanar neighbours three faces may lie in one plane. *)
let test_coplanar () =
  let lid = [| ("p", [| 4; 5; 6 |]); ("q", [| 4; 6; 7 |]) |] in
  let walls = Array.of_list (List.filter (fun (n, _) -> n <> "top") (Array.to_list sides)) in
  expect "a lid of two triangles" (corners 0) (Array.append walls lid) [ Coplanar_neighbours (5, 6) ];
  Alcotest.(check (option string)) "the hint" (Some "merge p and q into one face")
    (Polyhedron_fault.hint ~vertex:string_of_int
       ~face:(fun f -> if f = 5 then "p" else "q")
       (Coplanar_neighbours (5, 6)))

(* D-4: condition 3 as printed lets flat sets through, and the paper's verdict is about names. *)
let test_paper () =
  let failing vertices faces =
    let paper = Definition_4_3.check (set vertices faces) in
    List.filter_map (fun (n, w) -> Option.map (fun _ -> n) w) paper.conditions
  in
  let check name expected vertices faces = Alcotest.(check (list int)) name expected (failing vertices faces) in
  let v = corners 0 in
  check "the cube" [] v sides;
  check "nothing" [ 1; 3; 7 ] [||] [||];
  check "an index out of range" [ 2 ] v (replace sides 1 ("top", [| 4; 5; 6; 8 |]));
  check "a face twice, rotated" [ 5; 7 ] v (Array.append sides [| ("lid", [| 6; 7; 4; 5 |]) |]);
  check "a face and its reverse are two faces" [ 7 ] v (Array.append sides [| turn sides.(1) |]);
  let line = Array.init 4 (fun i -> (string_of_int i, Vec.of_ints i (2 * i) 0)) in
  let tetrahedron =
    [| ("p", [| 0; 2; 1 |]); ("q", [| 0; 1; 3 |]); ("r", [| 0; 3; 2 |]); ("s", [| 1; 2; 3 |]) |]
  in
  check "on a line" [ 3; 4; 6 ] line tetrahedron;
  let square =
    Array.mapi
      (fun i p -> (string_of_int i, p))
      [| Vec.of_ints 0 0 0; Vec.of_ints 1 0 0; Vec.of_ints 1 1 0; Vec.of_ints 0 1 0 |]
  in
  let flat =
    [| ("p", [| 0; 1; 2 |]); ("q", [| 0; 2; 3 |]); ("r", [| 0; 3; 1 |]); ("s", [| 1; 3; 2 |]) |]
  in
  check "flat, but not collinear" [ 6 ] square flat

(* D-1, D-7: the sides of f0 end where they began, and any two of its consecutive sides give its normal. *)
let test_face_of_the_paper () =
  let face = [| 0; 1; 2; 3 |] in
  let points, _ = Ivec.of_vecs (Array.map snd (corners 0)) in
  let normal = Face_check.normal points face in
  let side i = Ivec.sub points.(face.((i + 1) mod 4)) points.(face.(i mod 4)) in
  for i = 0 to 3 do
    let n = Ivec.cross (side i) (side (i + 1)) in
    Alcotest.(check bool) "same direction" true (Ivec.equal (Ivec.primitive n) (Ivec.primitive normal))
  done;
  let p = cube in
  let names = List.map (Polyhedron.feature_name p) (Polyhedron.downgrade p (Feature.Face 0)) in
  Alcotest.(check (list string)) "four sides" [ "[a,b]"; "[a,d]"; "[b,c]"; "[c,d]" ] names

let test_report () =
  let text vertices faces = Solid_report.to_text ~name:"it" (Solid_report.make (set vertices faces)) in
  let has name part whole =
    let n = String.length part in
    let rec at i = i + n <= String.length whole && (String.equal (String.sub whole i n) part || at (i + 1)) in
    Alcotest.(check bool) (name ^ ": " ^ part) true (at 0)
  in
  let good = text (corners 0) sides and moved = text (corners 3) sides in
  List.iter
    (fun part -> has "the cube" part good)
    [ "convex closed polyhedron: yes"; "vertices: 8, edges: 12, faces: 6"; "volume: 8"; "(16/3, 0, 0)"; "= -10" ];
  has "moved" "SC0312" moved;
  has "moved" "centroid: (3, 0, 0)" moved;
  let bad = text (corners 0) (Array.map turn sides) in
  has "inside out" "convex closed polyhedron: no" bad;
  has "inside out" "oriented inward" bad;
  has "inside out" "all seven conditions hold" bad

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("polyhedron",
   [
     ("Def-4.1", [ case "rotation equivalence" test_rotation ]);
     ("Def-4.2", [ case "downgrade" test_downgrade; case "closure" test_closure ]);
     ("Def-4.3", [ case "faults" test_faults; case "flat sets" test_flat ]);
     ("I-1", [ case "edges are unordered" test_edges; case "names" test_names ]);
     ("I-2", [ case "the printed conditions" test_paper; case "both verdicts in one report" test_report ]);
     ("D-1", [ case "the sides of a face" test_face_of_the_paper ]);
     ("D-3", [ case "both verdicts in one report" test_report ]);
     ("D-4", [ case "the printed conditions" test_paper ]);
     ("D-6", [ case "degenerate features" test_degenerate ]);
     ("D-7", [ case "the normal of a face" test_face_of_the_paper ]);
     ("D-8", [ case "coplanar neighbours" test_coplanar ]);
     ("transform", [ case "linear images" test_transform ]);
   ])
