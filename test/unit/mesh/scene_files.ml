(* Scenes of VRML and X3D as tests write and read them. *)
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
