(* What faces are called in files that name groups of them. *)
open Scc_base
open Scc_mesh

let read path text = Result.map fst (Mesh.read ~files:Beside.none ~path text)

let names_of path text =
  match read path text with
  | Ok ifs -> String.concat " " (Array.to_list (Array.map fst ifs.ifs_faces))
  | Error d -> Alcotest.fail d.Diag.message

let obj_faces groups =
  "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
  ^ String.concat "" (List.map2 (fun g f -> g ^ "f " ^ f ^ "\n") groups [ "1 3 2"; "1 2 4"; "1 4 3"; "2 3 4" ])

let x3d_sets shapes =
  let set (shape, own) =
    Printf.sprintf "<Shape%s><IndexedFaceSet%s coordIndex='0 1 2 -1'>" shape own
    ^ "<Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet></Shape>"
  in
  "<X3D><Scene>" ^ String.concat "" (List.map set shapes) ^ "</Scene></X3D>"

let vrml_sets shapes =
  let set (shape, own) =
    Printf.sprintf "%s Shape { geometry %s IndexedFaceSet {" shape own
    ^ " coord Coordinate { point [ 0 0 0 1 0 0 0 1 0 ] } coordIndex [ 0 1 2 ] } }\n"
  in
  "#VRML V2.0 utf8\n" ^ String.concat "" (List.map set shapes)

let named =
  let obj = List.map (fun (groups, names) -> ("t.obj", obj_faces groups, names)) in
  obj
    [
      ([ ""; ""; ""; "" ], "f0 f1 f2 f3"); ([ "o Cube\n"; ""; ""; "" ], "f0 f1 f2 f3");
      ([ "g top\n"; "g side\n"; ""; "g last\n" ], "top side0 side1 last");
      ([ ""; "g top\n"; "g\n"; "g default\n" ], "f0 top f2 f3");
      ([ "o A\n"; "g b c\n"; "o D\n"; "" ], "A b D0 D1"); ([ "g a2\n"; ""; "g b\n"; "" ], "a2_0 a2_1 b0 b1");
      ([ "g f1\n"; "g\n"; "g f0\n"; "g v1\n" ], "f1 f1_ f0 f3");
      ([ "g x.y-z\n"; "g 4th\n"; "g \xC3\xA9\n"; "g _\n" ], "x_y_z g4th g__ g_");
      ([ "g side\n"; ""; "g side0\n"; "g t\n" ], "f0 side1 side0 t");
      ([ "g process\n"; "g bond\n"; "g on\n"; "o only\n" ], "gprocess bond gon gonly");
      ([ "g process\n"; "g gprocess\n"; "g nil\n"; "" ], "f0 gprocess nil0 nil1");
    ]
  @ [
    ( "t.x3d",
      x3d_sets [ (" DEF='a'", ""); ("", ""); (" DEF='b'", " DEF='&#99;'"); ("", " DEF='d'") ], "a f1 c d" );
    ("t.wrl", vrml_sets [ ("DEF a", ""); ("", ""); ("DEF b", "DEF c"); ("", "DEF d") ], "a f1 c d");
    ("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "f0");
  ]

let naming () =
  List.iter (fun (path, text, expected) -> Alcotest.(check string) text expected (names_of path text)) named

let suite = ("names", [ ("names", [ Alcotest.test_case "of faces" `Quick naming ]) ])
