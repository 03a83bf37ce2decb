(* Every node and field of VRML and X3D is read, still or refused, at its place and elsewhere. *)
open Scc_mesh
open Scene_files

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
      let of_inline = row.kind = "Inline" && List.mem f [ "url"; "load" ] in
      let moves = of_inline || List.mem f moving && not (row.kind = "LOD" && f = "center") in
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

(* What is shown somewhere is not passed over in silence where it does not belong. *)
let check_misplaced row () =
  let shows = List.mem row.mark [ "read"; "left"; "unread" ] in
  let n = node row.kind [] in
  let outside before after = ("t.x3d", before ^ xml n ^ after ^ "<Scene>" ^ xml tetrahedron ^ "</Scene></X3D>") in
  let refuse (path, text) =
    match found path text with
    | Error (("SC0320" | "SC0321"), _) -> ()
    | Error (code, _) -> Alcotest.failf "%s: %s" code text
    | Ok _ -> Alcotest.failf "it is read: %s" text
  in
  List.iter refuse [ outside "<X3D>" ""; outside "<X3D><head>" "</head>" ];
  let inside field = both [ tetrahedron; node "Transform" [ (field, N [ n ]) ] ] in
  let elsewhere = [ "geometry"; "coord"; "shape" ] @ if row.role = "children" then [] else [ "children" ] in
  if shows then List.iter (fun field -> List.iter refuse (inside field)) elsewhere;
  if shows && List.mem row.role [ "geometry"; "coord" ] then List.iter refuse (both [ tetrahedron; n ])

(* Words where nodes belong, nodes where words do, too many of them, and a field that is there twice. *)
let check_values row () =
  let wrong (f, nodes) =
    let n = node "Group" [] in
    let values = if nodes then [ W "odd"; W "1" ] else [ W "odd"; W "1 odd"; N [ n ] ] in
    List.map (fun value -> (f, value)) values
  in
  let one (f, value) =
    let others = if row.kind = "Switch" && f <> "whichChoice" then [ ("whichChoice", W "0") ] else [] in
    let refuse (path, text) =
      match found path text with
      | Error _ -> ()
      | Ok _ -> Alcotest.failf "%s.%s is read: %s" row.kind f text
    in
    List.iter refuse (beside row (others @ [ (f, value) ]))
  in
  match Scene_table.find row.kind with
  | Read { read; _ } ->
    let own = List.filter (fun (f, _) -> List.mem f read) row.own in
    List.iter one (List.concat_map wrong own)
  | Still | Left_out | Unread _ -> ()

let complete () =
  let listed = List.filter_map (fun r -> if r.mark = "unread" then None else Some r.kind) rows in
  Alcotest.(check (list string)) "the table has no other nodes" (List.sort String.compare listed) Scene_table.kinds

let suite =
  let each check = List.map (fun r -> Alcotest.test_case r.kind `Quick (check r)) rows in
  ( "scene nodes",
    [
      ("nodes", Alcotest.test_case "the table" `Quick complete :: each check_row);
      ("misplaced", each check_misplaced);
      ("values", each check_values);
    ] )
