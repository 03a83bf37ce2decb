(* Scenes of VRML and X3D: every node and field of the formats is read, still or refused; what is read is where the
   specifications put it. *)
open Scc_base
open Scc_exact
open Scc_geometry
open Scc_mesh

let read path text = Mesh.read ~files:Beside.none ~path text

(* {1 Both ways to write a scene} *)

type written = { kind : string; name : string; fields : (string * value) list }
and value = W of string | N of written list | Again of string

let node ?(name = "") kind fields = { kind; name; fields }

let rec vrml n =
  let value = function
    | W words -> "[ " ^ words ^ " ]"
    | N nodes -> "[ " ^ String.concat " " (List.map vrml nodes) ^ " ]"
    | Again name -> "USE " ^ name
  in
  let field (f, v) = f ^ " " ^ value v in
  (if n.name = "" then "" else "DEF " ^ n.name ^ " ")
  ^ n.kind ^ " { " ^ String.concat " " (List.map field n.fields) ^ " }"

let quoted words = "'" ^ String.map (function '"' -> '\t' | c -> c) words ^ "'"

let rec xml ?(role = "") n =
  let attribute = function f, W w -> Some (Printf.sprintf " %s=%s" f (quoted w)) | _, (N _ | Again _) -> None in
  let words = List.filter_map attribute n.fields in
  let inside = function
    | _, W _ -> ""
    | role, N nodes -> String.concat "" (List.map (xml ~role) nodes)
    | role, Again name -> Printf.sprintf "<Group USE='%s' containerField='%s'/>" name role
  in
  Printf.sprintf "<%s%s%s%s>%s</%s>" n.kind
    (if n.name = "" then "" else " DEF='" ^ n.name ^ "'")
    (if role = "" then "" else " containerField='" ^ role ^ "'")
    (String.concat "" words)
    (String.concat "" (List.map inside n.fields))
    n.kind

let both nodes =
  [
    ("t.wrl", "#VRML V2.0 utf8\n" ^ String.concat "\n" (List.map vrml nodes));
    ("t.x3d", "<X3D><Scene>\n" ^ String.concat "\n" (List.map xml nodes) ^ "</Scene></X3D>");
  ]

let describe (set : Polyhedron.ifs) =
  let face (_, f) = String.concat " " (List.map string_of_int (Array.to_list f)) in
  String.concat "\n"
    (List.map (fun (_, v) -> Vec.to_string v) (Array.to_list set.ifs_vertices)
     @ List.map face (Array.to_list set.ifs_faces))

let found path text =
  match read path text with
  | Ok (set, warnings) -> Ok (describe set, List.map (fun (d : Diag.t) -> d.code) warnings)
  | Error (d : Diag.t) -> Error (d.code, String.sub text d.span.start (min 12 (String.length text - d.span.start)))

let show = function
  | Ok (set, warnings) -> set ^ "\n" ^ String.concat " " warnings
  | Error (code, at) -> code ^ " at " ^ at

let same what expected text = Alcotest.(check string) what expected (show text)

let coordinates = node "Coordinate" [ ("point", W "0 0 0, 2 0 0, 0 2 0, 0 0 2") ]

let tetrahedron =
  let index = W "0 2 1 -1 0 1 3 -1 0 3 2 -1 1 2 3 -1" in
  let faces = node "IndexedFaceSet" [ ("coord", N [ coordinates ]); ("coordIndex", index) ] in
  node "Shape" [ ("geometry", N [ faces ]) ]

let alone = show (found "t.wrl" ("#VRML V2.0 utf8\n" ^ vrml tetrahedron))

(* {1 Every node and field of the specifications} *)

type row = { kind : string; mark : string; role : string; own : (string * bool) list }

let rows =
  let lines =
    let file = open_in_bin "x3d_nodes.txt" in
    let text = really_input_string file (in_channel_length file) in
    close_in file;
    String.split_on_char '\n' text
  in
  let field text =
    match String.split_on_char ':' text with
    | [ name; kind ] -> (name, String.equal kind "n")
    | _ -> Alcotest.fail text
  in
  let row line =
    match String.split_on_char ' ' line with
    | kind :: mark :: role :: own -> { kind; mark; role; own = List.map field own }
    | _ -> Alcotest.fail line
  in
  List.map row (List.filter (fun l -> l <> "" && l.[0] <> '#') lines)

(* A node beside the tetrahedron: geometries stand in a shape, points in a set of points. *)
let placed row own =
  let n = node row.kind own in
  match row.role with
  | "geometry" -> node "Shape" [ ("geometry", N [ n ]) ]
  | "coord" -> node "Shape" [ ("geometry", N [ node "PointSet" [ ("coord", N [ n ]) ] ]) ]
  | _ -> n

let beside row own = both [ tetrahedron; placed row own ]

let starts prefix text =
  let n = String.length prefix in
  String.length text >= n && String.sub text 0 n = prefix

let refused what code at (path, text) =
  match found path text with
  | Error (c, place) when String.equal c code && starts (String.sub at 0 (min 12 (String.length at))) place -> ()
  | other -> Alcotest.fail (Printf.sprintf "%s: %s\nexpected %s at %s\nin %s" what (show other) code at text)

(* Nodes that are read show what is in them; the fields are filled with what a reader cannot but notice. *)
let unreadable = node "NurbsSet" []

(* By the specifications these say what is shown, and where. *)
let moving =
  String.split_on_char ' '
    "children visible translation rotation scale center scaleOrientation choice whichChoice level shape geometry \
     coord coordIndex index ccw stripCount fanCount xDimension zDimension xSpacing zSpacing height size radius \
     bottom side top bottomRadius point crossSection spine orientation beginCap endCap"

(* By the specifications these may have nodes of any kind, which are not shown there. *)
let referring =
  [
    "Collision.proxy"; "ComposedShader.field"; "GeoMetadata.data"; "LoadSensor.children"; "LoadSensor.watchList";
    "PackagedShader.field"; "Script.field"; "ShaderProgram.field"; "TransformSensor.targetObject";
  ]
  @ List.concat_map
    (fun kind -> [ kind ^ "PickSensor.pickTarget"; kind ^ "PickSensor.pickingGeometry" ])
    [ "Line"; "Point"; "Primitive"; "Volume" ]

(* Nothing is shown in a field: what is there is nothing that would be shown elsewhere, at any depth. *)
let check_unseen what row f kind =
  let inner = node kind [] in
  let around = [ inner; node "ViewpointGroup" [ ("children", N [ inner ]) ] ] in
  let one (inner : written) (path, text) =
    let code = match kind with "WorldInfo" -> "" | "NurbsSet" -> "SC0321" | _ -> "SC0320" in
    match found path text with
    | Error (found, place) when String.equal found code && starts kind place -> ()
    | other when code = "" || (inner.kind = kind && List.mem what referring) ->
      same (what ^ " with a " ^ kind ^ " changes nothing") alone other
    | other -> Alcotest.fail (Printf.sprintf "%s with a %s: %s\n%s" what kind (show other) text)
  in
  let shown = if List.mem row.role [ "geometry"; "coord" ] && row.mark = "read" then [] else around in
  List.iter (fun inner -> List.iter (one inner) (beside row [ (f, N [ inner ]) ])) shown

let check_field row (f, nodes) =
  let what = row.kind ^ "." ^ f in
  let is_still =
    match Scene_table.find row.kind with Read { still; _ } -> List.mem f still | _ -> row.mark = "still"
  in
  let value =
    if not nodes then W "\"odd\"" else N [ (if is_still then node "WorldInfo" [] else unreadable) ]
  in
  (* A switch is to show the choice, and a level of detail what it has. *)
  let others = if row.kind = "Switch" && nodes then [ ("whichChoice", W "0") ] else [] in
  let files = beside row (others @ [ (f, value) ]) in
  let is_read =
    match Scene_table.find row.kind with
    | Read { read; still; _ } ->
      Alcotest.(check bool) (what ^ " is in one list") true (List.mem f read <> List.mem f still);
      let moves = List.mem f moving && not (row.kind = "LOD" && f = "center") in
      Alcotest.(check bool) (what ^ " is read if it moves points") moves (List.mem f read);
      List.mem f read
    | Still | Left_out | Unread _ -> false
  in
  let one (path, text) =
    if not is_read then same (what ^ " changes nothing: " ^ path) alone (found path text)
    else
      match found path text with
      | Error _ -> ()
      | Ok _ -> Alcotest.fail (what ^ " is not read: " ^ text)
  in
  if nodes && not is_read then List.iter (check_unseen what row f) [ "Shape"; "Text"; "NurbsSet"; "WorldInfo" ];
  (* Shapes need what they are made of: only that their other fields are known is tested here. *)
  if is_read || not (List.mem row.role [ "geometry"; "coord" ]) || row.mark = "still" then List.iter one files

let check_row row () =
  match (row.mark, Scene_table.find row.kind) with
  | "unread", Unread _ -> List.iter (refused row.kind "SC0321" row.kind) (beside row [])
  | "still", Still ->
    List.iter (fun (path, text) -> same row.kind alone (found path text)) (beside row []);
    List.iter (check_field row) row.own
  | "left", Left_out ->
    let files = beside row (List.map (fun (f, _) -> (f, W "\"odd\"")) row.own) in
    List.iter (fun (path, text) -> same row.kind (alone ^ "SC0324") (found path text)) files
  | "read", Read _ -> List.iter (check_field row) row.own
  | mark, _ -> Alcotest.fail (Printf.sprintf "%s is not in the list `%s`" row.kind mark)

let complete () =
  let listed = List.filter_map (fun r -> if r.mark = "unread" then None else Some r.kind) rows in
  Alcotest.(check (list string)) "the table has no other nodes" (List.sort String.compare listed) Scene_table.kinds

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
    ("USE inside, XML", "t.x3d", "<X3D><Group DEF='G'><Group USE='G'/></Group></X3D>", "SC0320 1:33");
    ("deep", "t.wrl", deep 100_000, "SC0320 2:19020");
    ("doubling", "t.wrl", doubling 60, "SC0320 doubling");
    ("an unknown field", "t.wrl", "#VRML V2.0 utf8\nGroup { childs [ ] }", "SC0321 2:9");
    ("an unknown node", "t.wrl", "#VRML V2.0 utf8\nGroop { }", "SC0321 2:1");
    ("an unread geometry, XML", "t.x3d", "<X3D><Shape><NurbsSweptSurface/></Shape></X3D>", "SC0321 1:14");
    ("two geometries", "t.x3d", "<X3D><Shape><Box/><Cone/></Shape></X3D>", "SC0320 1:20");
    ("a field twice", "t.x3d", "<X3D><Shape><Box size='1 1 1' size='2 2 2'/></Shape></X3D>", "SC0320 1:31");
    ("a tag of another element", "t.x3d", "<X3D><Group></Groop></X3D>", "SC0320 1:14");
    ("an element without an end", "t.x3d", "<X3D><Group>", "SC0320 1:7");
    ("degrees", "t.x3d", "<X3D><head><unit category='angle' name='d' conversionFactor='0.0174'/></head></X3D>",
     "SC0321 1:13");
    ("a scale of zero", "t.wrl", "#VRML V2.0 utf8\nTransform { scale 1 0 1 children Shape { geometry Box { } } }",
     "SC0320 2:1");
    ("no axis", "t.wrl", "#VRML V2.0 utf8\nTransform { rotation 0 0 0 1 }", "SC0320 2:1");
    ("a bent grid", "t.wrl", heights "0 0 0 1", "SC0323"); ("a flat grid", "t.wrl", heights "0 1 2 3", "");
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
      ("nodes", Alcotest.test_case "the table" `Quick complete
                :: List.map (fun r -> Alcotest.test_case r.kind `Quick (check_row r)) rows);
      ("places", List.map check_place places @ List.map check_set sets);
      ("distances", [ Alcotest.test_case "distances" `Quick distances ]);
      ("refusals", List.map check_refusal refusals);
    ] )
