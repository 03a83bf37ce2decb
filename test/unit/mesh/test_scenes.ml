(* Scenes of VRML and X3D: what is read is where the specifications put it, and what is refused. *)
open Scc_base
open Scc_exact
open Scc_geometry
open Scene_files

(* {1 Where things are} *)

let box fields = node "Shape" [ ("geometry", N [ node "Box" fields ]) ]

(* The least and the greatest corner, and the volume. *)
let extent path text =
  match read path text with
  | Error d -> "error " ^ d.message
  | Ok (set, warnings) ->
    let points = List.map snd (Array.to_list set.ifs_vertices) in
    let pick f c = List.fold_left (fun a v -> f a (c v)) (c (List.hd points)) points in
    let corner f = Vec.make (pick f (fun v -> v.Vec.x)) (pick f (fun v -> v.Vec.y)) (pick f (fun v -> v.Vec.z)) in
    let accepted = match Polyhedron.of_ifs set with Ok _ -> "solid" | Error _ -> "no solid" in
    String.concat " "
      ([ Vec.to_string (corner Rat.min); Vec.to_string (corner Rat.max); accepted ]
       @ List.map (fun (d : Diag.t) -> d.code) warnings)

let transform fields children = node "Transform" (fields @ [ ("children", N children) ])

let places =
  let quarter = "0 0 1 1.5707963267948966" in
  [
    ("a box", [ box [] ], "(-1, -1, -1) (1, 1, 1) solid");
    ("its size", [ box [ ("size", W "2 4 6") ] ], "(-1, -2, -3) (1, 2, 3) solid");
    ("a translation", [ transform [ ("translation", W "1 2 3") ] [ box [] ] ], "(0, 1, 2) (2, 3, 4) solid");
    ("a mirror", [ transform [ ("scale", W "-1 1 1") ] [ tetrahedron ] ], "(-2, 0, 0) (0, 2, 2) solid");
    ( "a quarter turn after a scale",
      [ transform [ ("rotation", W quarter); ("scale", W "2 1 1"); ("translation", W "5 0 0") ] [ box [] ] ],
      "(4, -2, -1) (6, 2, 1) solid" );
    ( "about a centre",
      [ transform [ ("center", W "1 0 0"); ("rotation", W "0 0 1 3.14159265") ] [ box [] ] ],
      "(1, -1, -1) (3, 1, 1) solid" );
    ( "a rounded quarter turn, with its distance",
      [ transform [ ("rotation", W "0 0 2 1.5708") ] [ box [ ("size", W "2 4 6") ] ] ],
      "(-2, -1, -3) (2, 1, 3) solid SC0323" );
    ( "scales along turned axes",
      [ transform [ ("scaleOrientation", W quarter); ("scale", W "2 1 1") ] [ box [] ] ],
      "(-1, -2, -1) (1, 2, 1) solid" );
    ( "transforms inside of each other",
      [ transform [ ("scale", W "2 2 2") ] [ transform [ ("translation", W "1 0 0") ] [ box [] ] ] ],
      "(0, -2, -2) (4, 2, 2) solid" );
    ( "a choice",
      [ node "Switch" [ ("whichChoice", W "1"); ("children", N [ tetrahedron; box [] ]) ] ],
      "(-1, -1, -1) (1, 1, 1) solid" );
    ( "the first level",
      [ node "LOD" [ ("children", N [ box []; tetrahedron ]) ] ],
      "(-1, -1, -1) (1, 1, 1) solid" );
    ( "no proxy",
      [ node "Collision" [ ("proxy", N [ tetrahedron ]); ("children", N [ box [] ]) ] ],
      "(-1, -1, -1) (1, 1, 1) solid" );
    ( "a part",
      [
        node "CADPart"
          [ ("translation", W "1 0 0"); ("children", N [ node "CADFace" [ ("shape", N [ box [] ]) ] ]) ];
      ],
      "(0, -1, -1) (2, 1, 1) solid" );
    ( "what is not visible",
      [ node "Group" [ ("visible", W "FALSE"); ("children", N [ tetrahedron ]) ]; box [] ],
      "(-1, -1, -1) (1, 1, 1) solid" );
    ( "a ball", [ node "Shape" [ ("geometry", N [ node "Sphere" [ ("radius", W "2") ] ]) ] ],
      "(-2, -2, -2) (2, 2, 2) solid SC0323" );
    ( "a cylinder",
      [ node "Shape" [ ("geometry", N [ node "Cylinder" [ ("radius", W "2"); ("height", W "6") ] ]) ] ],
      "(-2, -3, -2) (2, 3, 2) solid SC0323" );
    ( "a cone",
      [ node "Shape" [ ("geometry", N [ node "Cone" [ ("bottomRadius", W "2"); ("height", W "6") ] ]) ] ],
      "(-2, -3, -2) (2, 3, 2) solid SC0323" );
    ( "used again",
      [
        node "Switch" [ ("children", N [ node ~name:"B" "Group" [ ("children", N [ box [] ]) ] ]) ];
        transform [ ("translation", W "3 0 0") ] [];
        node "Transform" [ ("translation", W "1 0 0"); ("children", Again "B") ];
      ],
      "(0, -1, -1) (2, 1, 1) solid" );
  ]

let check_place (what, nodes, expected) =
  let one (path, text) = Alcotest.(check string) text expected (extent path text) in
  let test () = List.iter one (both nodes) in
  Alcotest.test_case what `Quick test

(* The same tetrahedron by every set of faces. *)
let sets =
  let all = "0 0 0, 2 0 0, 0 2 0, 0 0 2" in
  let corners = "0 0 0, 0 2 0, 2 0 0, 0 0 0, 2 0 0, 0 0 2, 0 0 0, 0 0 2, 0 2 0, 2 0 0, 0 2 0, 0 0 2" in
  let set kind points fields = (kind, fields, points) in
  [
    set "IndexedTriangleSet" all [ ("index", W "0 2 1 0 1 3 0 3 2 1 2 3") ];
    set "IndexedTriangleStripSet" all [ ("index", W "0 2 1 3 0 2 -1") ];
    set "IndexedTriangleFanSet" all [ ("index", W "0 2 1 3 2 -1 1 2 3") ];
    set "TriangleSet" corners [];
    set "TriangleFanSet" "0 0 0, 0 2 0, 2 0 0, 0 0 2, 0 2 0, 2 0 0, 0 2 0, 0 0 2" [ ("fanCount", W "5 3") ];
    set "TriangleStripSet" "0 0 0, 0 2 0, 2 0 0, 0 0 2, 0 0 0, 0 2 0" [ ("stripCount", W "6") ];
  ]

let check_set (kind, fields, points) =
  let test () =
    List.iter
      (fun (coordinate, ccw) ->
         let coord = N [ node coordinate [ ("point", W points) ] ] in
         let scale = W (if ccw = "FALSE" then "-1 1 1" else "1 1 1") in
         let set = node kind ([ ("coord", coord); ("ccw", W ccw) ] @ fields) in
         let scene = transform [ ("scale", scale) ] [ node "Shape" [ ("geometry", N [ set ]) ] ] in
         (* Clockwise faces, which a mirror turns over twice: they would be inside out without the mirror. *)
         let expected = if ccw = "FALSE" then "(-2, 0, 0) (0, 2, 2) no solid" else "(0, 0, 0) (2, 2, 2) solid" in
         List.iter (fun (path, text) -> Alcotest.(check string) text expected (extent path text)) (both [ scene ]))
      [ ("Coordinate", "TRUE"); ("CoordinateDouble", "TRUE"); ("Coordinate", "FALSE") ]
  in
  Alcotest.test_case kind `Quick test

(* {1 Distances} *)

let heights =
  Printf.sprintf "#VRML V2.0 utf8\nShape { geometry ElevationGrid { xDimension 2 zDimension 2 height [ %s ] } }"

(* The distance that is reported for turned and curved shapes, against a scene in floats. *)
let distances () =
  let ball scale = Printf.sprintf
      "Transform { scale %s rotation 1 2 3 0.7 translation 5 0 0 children Shape { geometry Sphere { } } }" scale in
  let told text =
    match read "t.wrl" text with
    | Ok (_, [ d ]) -> Scanf.sscanf d.message "what is read is up to %f" Fun.id
    | Ok _ | Error _ -> Alcotest.fail "a warning was expected"
  in
  let distance scale = told ("#VRML V2.0 utf8\n" ^ ball scale) in
  Alcotest.(check (float 0.)) "half of how far the diagonals are apart" 0.5 (told (heights "0 3 1 5"));
  let one = distance "1 1 1" in
  Alcotest.(check bool) "at most a hundredth of the radius, and a little" true (one > 0.005 && one < 0.010001);
  let factor = distance "1 3 1" /. one in
  Alcotest.(check bool) "it grows with the greatest scale" true (Float.abs (factor -. 3.) < 0.02)

(* {1 What is refused} *)

let deep n =
  "#VRML V2.0 utf8\n" ^ String.concat "" (List.init n (fun _ -> "Group { children [ ")) ^ vrml (box [])
  ^ String.concat "" (List.init n (fun _ -> "] } "))

let doubling n =
  let level k =
    Printf.sprintf "DEF G%d Group { children [ USE G%d USE G%d ] }\n" (k + 1) k k
  in
  "#VRML V2.0 utf8\nDEF G0 " ^ vrml (box []) ^ "\n" ^ String.concat "" (List.init n level)

let refusals =
  [
    ("a route", "t.wrl", "#VRML V2.0 utf8\nDEF T Transform { children Shape { geometry Box { } } }\n\
                          DEF P PositionInterpolator { }\nROUTE P.value_changed TO T.set_translation\n", "SC0324");
    ("a harmless route", "t.wrl", "#VRML V2.0 utf8\nDEF T Shape { geometry Box { } appearance Appearance { \
                                   material DEF M Material { } } }\nROUTE M.x TO M.set_diffuseColor\n", "");
    ("USE inside", "t.wrl", "#VRML V2.0 utf8\nDEF G Group { children [ USE G ] }", "SC0320 2:30");
    ("USE before", "t.wrl", "#VRML V2.0 utf8\nUSE G", "SC0320 2:5");
    ("USE inside, XML", "t.x3d",
     "<X3D><Scene><Group DEF='G'><Group USE='G'/></Group></Scene></X3D>", "SC0320 1:40");
    ("deep", "t.wrl", deep 100_000, "SC0320 2:19020");
    ("doubling", "t.wrl", doubling 60, "SC0320 doubling");
    ("an unknown field", "t.wrl", "#VRML V2.0 utf8\nGroup { childs [ ] }", "SC0321 2:9");
    ("an unknown node", "t.wrl", "#VRML V2.0 utf8\nGroop { }", "SC0321 2:1");
    ("an unread geometry, XML", "t.x3d", "<Scene><Shape><NurbsSweptSurface/></Shape></Scene>", "SC0321 1:16");
    ("two geometries", "t.x3d", "<Scene><Shape><Box/><Cone/></Shape></Scene>", "SC0320 1:22");
    ("a field twice", "t.x3d", "<Scene><Shape><Box size='1 1 1' size='2 2 2'/></Shape></Scene>", "SC0320 1:33");
    ("a tag of another element", "t.x3d", "<Scene><Group></Groop></Scene>", "SC0320 1:16");
    ("an element without an end", "t.x3d", "<Scene><Group>", "SC0320 1:9");
    ("a field twice, VRML", "t.wrl", "#VRML V2.0 utf8\nGroup { children [ ] children [ ] }", "SC0320 2:22");
    ("a shape in the head", "t.x3d", "<X3D><head><Shape/></head><Scene/></X3D>", "SC0320 1:13");
    ("a shape beside the scene", "t.x3d", "<X3D><Shape/><Scene/></X3D>", "SC0320 1:7");
    ("a shape without a scene", "t.x3d", "<Shape><Box/></Shape>", "SC0320 1:2");
    ("a shape in a statement", "t.x3d", "<X3D><head><meta><Shape/></meta></head></X3D>", "SC0320 1:19");
    ("a shape in a ROUTE", "t.x3d",
     "<Scene><ROUTE fromNode='A' toNode='B' toField='c'><Shape/></ROUTE></Scene>", "SC0320 1:52");
    ("a shape in a declaration", "t.x3d",
     "<Scene><ProtoDeclare name='P'><Shape/></ProtoDeclare></Scene>", "SC0320 1:32");
    ("a shape in an instance", "t.x3d",
     "<Scene><ProtoDeclare name='P'><ProtoBody><Group/></ProtoBody></ProtoDeclare>\
      <ProtoInstance name='P'><Shape/></ProtoInstance></Scene>", "SC0320 1:102");
    ("two bodies", "t.x3d",
     "<Scene><ProtoDeclare name='P'><ProtoBody/><ProtoBody/></ProtoDeclare></Scene>", "SC0320 1:44");
    ("IS outside of a prototype", "t.x3d", "<Scene><Shape><IS/></Shape></Scene>", "SC0320 1:16");
    ("degrees", "t.x3d", "<X3D><head><unit category='angle' name='d' conversionFactor='0.0174'/></head></X3D>",
     "SC0321 1:13");
    ("a scale of zero", "t.wrl", "#VRML V2.0 utf8\nTransform { scale 1 0 1 children Shape { geometry Box { } } }",
     "SC0320 2:1");
    ("no axis", "t.wrl", "#VRML V2.0 utf8\nTransform { rotation 0 0 0 1 }", "SC0320 2:1");
    ("a bent grid", "t.wrl", heights "0 0 0 1", "SC0323"); ("a flat grid", "t.wrl", heights "0 1 2 3", "");
    ("a tag with a sign", "t.x3d", "<Scene><Shape><Box size='1 1 1'<></Shape></Scene>", "SC0320 1:32");
    ("a slash within a tag", "t.x3d", "<Scene><Shape><Box / size='1 1 1'/></Shape></Scene>", "SC0320 1:20");
    ("a `<` in a value", "t.x3d", "<Scene><Shape><Box id='<'/></Shape></Scene>", "SC0320 1:24");
    ("a reference that does not end", "t.x3d", "<X3D version='3&0'><Scene/></X3D>", "SC0320 1:16");
    ("an unknown reference", "t.x3d", "<Scene><Shape id='&a;'><Box/></Shape></Scene>", "SC0320 1:19");
    ("an attribute twice", "t.x3d", "<X3D version='3.0' version='3.0'/>", "SC0320 1:20");
    ("an attribute of X3D", "t.x3d", "<X3D foo='1'><Scene/></X3D>", "SC0321 1:6");
    ("an attribute of the scene", "t.x3d", "<X3D><Scene DEF='a'/></X3D>", "SC0321 1:13");
    ("another element used", "t.x3d", "<Scene><Group DEF='A'/><Transform USE='A'/></Scene>", "SC0320 1:25");
    ("a header without its blank", "t.wrl", "#VRML V2.0utf8\n", "SC0321 1:1");
    ("another encoding", "t.wrl", "#VRML V2.0 utf9\n", "SC0321 1:1");
    ("a later version", "t.x3dv", "#X3D V9.9 utf8\n", "SC0321 1:1");
    ("declarations", "t.x3d", "<!DOCTYPE X3D [ <!ENTITY a 'b'> ]><X3D/>", "SC0320 1:1");
  ]

let check_refusal (what, path, text, expected) =
  let test () =
    let text_of (d : Diag.t) =
      let line, column = Source.position (Source.make ~name:path text) d.span.start in
      if what = "doubling" then d.code ^ " doubling" else Printf.sprintf "%s %d:%d" d.code line column
    in
    let found =
      match read path text with
      | Ok (_, warnings) -> String.concat " " (List.map (fun (d : Diag.t) -> d.code) warnings)
      | Error d -> text_of d
    in
    Alcotest.(check string) what expected found
  in
  Alcotest.test_case what `Quick test

let suite =
  ( "scenes",
    [
      ("places", List.map check_place places @ List.map check_set sets);
      ("distances", [ Alcotest.test_case "distances" `Quick distances ]);
      ("refusals", List.map check_refusal refusals);
    ] )
