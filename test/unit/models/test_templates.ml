(* What section 4.1 of the paper says of its cube, on the cube of specs/models/figure4.sc. *)

open Scc_exact
open Scc_geometry
open Scc_test_models

let elaborated name = Load.exactly (Load.file (Filename.concat "../../../specs/models" name))
let template model name = List.assoc name (elaborated model).Scc_elaborate.Elaborate.templates
let cube () = template "figure4.sc" "Cube"

let face p name : Feature.t =
  match Polyhedron.find_face p name with
  | Some i -> Face i
  | None -> Alcotest.failf "no face %s" name

let vertex p name =
  match Polyhedron.find_vertex p name with Some i -> i | None -> Alcotest.failf "no vertex %s" name

let names p features = List.sort String.compare (List.map (Polyhedron.feature_name p) features)
let check what expected got = Alcotest.(check (list string)) what expected got

(* The paper's tuples: f0 = [v0,v1,v2,v3]. *)
let edges_of_a_face () =
  let p = cube () in
  check "dg(f0)" [ "[v0,v1]"; "[v0,v3]"; "[v1,v2]"; "[v2,v3]" ]
    (names p (Polyhedron.downgrade p (face p "f0")));
  Alcotest.(check bool) "[v3,v4] is no edge of it" true
    (not (List.mem "[v3,v4]" (names p (Polyhedron.downgrade p (face p "f0")))))

let downgrade () =
  let p = cube () in
  let edge : Feature.t =
    match Polyhedron.find_edge p (vertex p "v1") (vertex p "v0") with
    | Some i -> Edge i
    | None -> Alcotest.fail "no edge"
  in
  check "dg(e0)" [ "v0"; "v1" ] (names p (Polyhedron.downgrade p edge));
  check "dg of a vertex" [] (names p (Polyhedron.downgrade p (Vertex 0)))

let closure () =
  let p = cube () in
  let close features = names p (Polyhedron.closure p features) in
  check "the paper's example"
    [ "[v0,v1]"; "[v0,v3]"; "[v1,v2]"; "[v2,v3]"; "f0"; "v0"; "v1"; "v2"; "v3" ]
    (close [ face p "f0"; Vertex (vertex p "v1") ]);
  let two = [ face p "f0"; face p "f2" ] in
  Alcotest.(check int) "neighbours share an edge and its ends" (2 + 7 + 6) (List.length (close two));
  let again = Polyhedron.closure p (Polyhedron.closure p two) in
  check "closing twice is closing once" (close two) (names p again)

let rotation () =
  let equivalent = Polyhedron.rotation_equivalent in
  let f0 = [| 0; 1; 2; 3 |] in
  List.iter
    (fun g -> Alcotest.(check bool) "a rotation" true (equivalent f0 g))
    [ f0; [| 3; 0; 1; 2 |]; [| 2; 3; 0; 1 |]; [| 1; 2; 3; 0 |] ];
  List.iter
    (fun g -> Alcotest.(check bool) "another face" false (equivalent f0 g))
    [ [| 3; 2; 1; 0 |]; [| 0; 2; 1; 3 |]; [| 0; 1; 2 |]; [| 0; 1; 2; 4 |] ]

let ifs (p : Polyhedron.t) = { Polyhedron.ifs_vertices = p.vertices; ifs_faces = p.faces }

let euler () =
  let printed = Definition_4_3.check (ifs (cube ())) in
  Alcotest.(check int) "with ordered edges" (-10) (Definition_4_3.euler_ordered printed);
  Alcotest.(check int) "with unordered edges" 2 (Definition_4_3.euler printed);
  Alcotest.(check bool) "all seven conditions" true (Definition_4_3.holds printed)

(* Any two consecutive edges of a face give its outward normal, whichever vertex its tuple starts with. *)
let normals () =
  let p = cube () in
  let solid = Solid.make ~id:0 p Mat.identity in
  let check_face i (name, corners) =
    let k = Array.length corners in
    let at j = snd p.vertices.(corners.(j mod k)) in
    for j = 0 to k - 1 do
      let n = Vec.cross (Vec.sub (at (j + 1)) (at j)) (Vec.sub (at (j + 2)) (at (j + 1))) in
      let n = Ivec.primitive (fst (Ivec.of_vec n)) in
      Alcotest.(check string) name (Ivec.to_string solid.normals.(i)) (Ivec.to_string n);
      Alcotest.(check bool) "outward" true (Rat.sign (Vec.dot (Ivec.to_vec n) (at j)) > 0)
    done
  in
  Array.iteri check_face p.faces

let mass () =
  let of_template model name = Mass_properties.of_polyhedron (template model name) in
  let check name (m : Mass_properties.t) volume x y z =
    Alcotest.(check string) (name ^ ": volume") volume (Rat.to_string m.volume);
    Alcotest.(check string) (name ^ ": centroid") "(0, 0, 0)" (Vec.to_string m.centroid);
    let i = Mass_properties.inertia ~mass:(Rat.of_int 3) m in
    Alcotest.(check (list string)) (name ^ ": inertia") [ x; y; z ]
      (List.map Rat.to_string [ i.r0.x; i.r1.y; i.r2.z ]);
    Alcotest.(check string) (name ^ ": no products of inertia") "0" (Rat.to_string i.r0.y)
  in
  (* m/12 times the sums of squared sides *)
  check "cube" (of_template "figure5.sc" "Cube") "8" "2" "2" "2";
  check "plank" (of_template "figure5.sc" "Plank") "8" "5/4" "5" "17/4"

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "templates"
    [
      ( "section 4.1",
        [
          case "Def-4.1: rotations of a tuple" rotation;
          case "Def-4.2: downgrade" downgrade;
          case "Def-4.2: closure" closure;
          case "D-1: the edges of f0" edges_of_a_face;
          case "I-1: edges count once" euler;
          case "D-7: normals" normals;
          case "Mass: the cube and the parallelepiped of Figure 5" mass;
        ] );
    ]
