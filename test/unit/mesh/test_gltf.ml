(* Every property and extension of glTF 2.0 is read, still or refused; what is read is where the specification puts
   it. *)
open Scc_base
open Scc_mesh

type json = Yojson.Safe.t
type step = K of string | I of int

(* {1 A file with every kind of object} *)

(* Twelve corners of four triangles: the fourth is (9, 9, 9), and put right by sparse values. *)
let data =
  let dense = Bytes.of_string Gltf_files.gltf_data in
  List.iter (fun k -> Bytes.set_int32_le dense (36 + (4 * k)) (Int32.bits_of_float 9.)) [ 0; 1; 2 ];
  Bytes.to_string dense ^ String.sub Gltf_files.gltf_data 36 12 ^ "\003"

let whole : json =
  Yojson.Safe.from_string
    (Printf.sprintf
       "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\
        \"meshes\":[{\"weights\":[0],\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,\
        \"material\":0,\"targets\":[{\"POSITION\":0}]}]}],\
        \"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":12,\
        \"sparse\":{\"count\":1,\"values\":{\"bufferView\":2},\
        \"indices\":{\"bufferView\":2,\"byteOffset\":12,\"componentType\":5121}}},\
        {\"bufferView\":1,\"componentType\":5121,\"type\":\"SCALAR\",\"count\":12}],\
        \"bufferViews\":[{\"buffer\":0,\"byteLength\":144},{\"buffer\":0,\"byteOffset\":144,\"byteLength\":12},\
        {\"buffer\":0,\"byteOffset\":156,\"byteLength\":13}],\
        \"buffers\":[{\"byteLength\":169,\"uri\":\"data:;base64,%s\"}],\
        \"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"path\":\"translation\"}}],\"samplers\":[{}]}],\
        \"cameras\":[{\"type\":\"perspective\",\"perspective\":{},\"orthographic\":{}}],\"images\":[{}],\
        \"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}},\"normalTexture\":{},\
        \"occlusionTexture\":{}}],\"samplers\":[{}],\"skins\":[{\"joints\":[0]}],\"textures\":[{}]}"
       (Base64.encode_string data))

let primitive = [ K "meshes"; I 0; K "primitives"; I 0 ]
let accessor = [ K "accessors"; I 0 ]
let goal = [ K "animations"; I 0; K "channels"; I 0; K "target" ]
let material = [ K "materials"; I 0 ]

let place = function
  | "glTF" -> []
  | "asset" -> [ K "asset" ]
  | "primitive" -> primitive
  | "attributes" -> primitive @ [ K "attributes" ]
  | "target" -> primitive @ [ K "targets"; I 0 ]
  | "sparse" -> accessor @ [ K "sparse" ]
  | "sparseIndices" -> accessor @ [ K "sparse"; K "indices" ]
  | "sparseValues" -> accessor @ [ K "sparse"; K "values" ]
  | "channel" -> [ K "animations"; I 0; K "channels"; I 0 ]
  | "goal" -> goal
  | "animationSampler" -> [ K "animations"; I 0; K "samplers"; I 0 ]
  | ("perspective" | "orthographic") as kind -> [ K "cameras"; I 0; K kind ]
  | ("pbrMetallicRoughness" | "normalTexture" | "occlusionTexture") as kind -> material @ [ K kind ]
  | "textureInfo" -> material @ [ K "pbrMetallicRoughness"; K "baseColorTexture" ]
  | "mesh" -> [ K "meshes"; I 0 ]
  | kind -> [ K (kind ^ "s"); I 0 ]

let words_of place =
  let step at = function
    | K name -> if at = "" then name else at ^ "." ^ name
    | I i -> Printf.sprintf "%s[%d]" at i
  in
  List.fold_left step "" place

(* {1 Changes} *)

let rec set place value (json : json) : json =
  match (place, json) with
  | [], _ -> value
  | K name :: rest, `Assoc members ->
    let old = Option.value (List.assoc_opt name members) ~default:(`Assoc []) in
    `Assoc (List.remove_assoc name members @ [ (name, set rest value old) ])
  | I i :: rest, `List values -> `List (List.mapi (fun k v -> if k = i then set rest value v else v) values)
  | _ -> Alcotest.fail "no such place"

let remove place name (json : json) =
  let rec get place (json : json) =
    match (place, json) with
    | [], _ -> json
    | K name :: rest, `Assoc members -> get rest (List.assoc name members)
    | I i :: rest, `List values -> get rest (List.nth values i)
    | _ -> Alcotest.fail "no such place"
  in
  match get place json with
  | `Assoc members -> set place (`Assoc (List.remove_assoc name members)) json
  | _ -> Alcotest.fail "no object"

type found = Same of string list | Other | Fault of string * string

let read_text text = Mesh.read ~files:Beside.none ~path:"t.gltf" text
let read json = read_text (Yojson.Safe.to_string json)

let alone =
  match read whole with
  | Ok (set, []) -> Scene_files.describe set
  | Ok _ | Error _ -> Alcotest.fail "the whole file is not read"

let found json =
  match read json with
  | Error (d : Diag.t) -> Fault (d.code, d.message)
  | Ok (set, warnings) when Scene_files.describe set = alone ->
    Same (List.map (fun (d : Diag.t) -> d.code) warnings)
  | Ok _ -> Other

let show = function
  | Same codes -> "the same " ^ String.concat " " codes
  | Other -> "another solid"
  | Fault (code, message) -> code ^ ": " ^ message

let still what json = Alcotest.(check string) (what ^ " changes nothing") "the same " (show (found json))

(* The message has the path of the object. *)
let refused what place json =
  match found json with
  | Fault ("SC0320", message) when String.starts_with ~prefix:(words_of place) message -> ()
  | other -> Alcotest.fail (Printf.sprintf "%s: %s" what (show other))

(* {1 The lists} *)

let lines name =
  let file = open_in_bin name in
  let text = really_input_string file (in_channel_length file) in
  close_in file;
  List.filter_map
    (fun line -> if line = "" || line.[0] = '#' then None else Some (String.split_on_char ' ' line))
    (String.split_on_char '\n' text)

let fitting : string -> json = function
  | "i" -> `Int 0
  | "n" -> `Float 0.5
  | "s" -> `String "odd"
  | "b" -> `Bool false
  | "a" -> `List []
  | "o" -> `Assoc []
  | other -> Alcotest.fail other

let wrong : string -> json = function "s" -> `Int 5 | _ -> `String "odd"

let own word =
  match String.split_on_char ':' word with
  | [ name; kind; mark ] -> (name, kind, mark)
  | _ -> Alcotest.fail word

let check_property kind word =
  let name, typed, mark = own word in
  let at = place kind in
  let what = kind ^ "." ^ name in
  let with_value value = set (at @ [ K name ]) value whole in
  match mark with
  | "r" -> refused what at (with_value (wrong typed))
  | "x" -> refused what at (with_value (fitting typed))
  | _ ->
    still what (with_value (fitting typed));
    still what (with_value (wrong typed))

let mark_of = function Gltf_table.Read -> "r" | Still -> "s" | Refused _ -> "x"
let numbered name = String.contains name '_'

let check_kind kind words =
  List.iter (check_property kind) words;
  let at = place kind in
  still (kind ^ ".extras") (set (at @ [ K "extras" ]) (`String "odd") whole);
  match List.assoc_opt kind Gltf_table.kinds with
  | None -> ()
  | Some rows ->
    let listed = List.map (fun (name, mark) -> name ^ " " ^ mark_of mark) rows in
    let written =
      List.filter_map
        (fun word -> match own word with n, _, m -> if numbered n then None else Some (n ^ " " ^ m))
        words
    in
    let sorted = List.sort String.compare in
    Alcotest.(check (list string)) ("the table of " ^ kind) (sorted written) (sorted listed);
    refused (kind ^ ".frob") at (set (at @ [ K "frob" ]) (`Int 1) whole);
    refused (kind ^ ".extensions") at (set (at @ [ K "extensions" ]) (`String "odd") whole);
    if kind <> "glTF" && kind <> "goal" then
      refused (kind ^ ", an extension") at (set (at @ [ K "extensions"; K "FROB_it" ]) (`Assoc []) whole)

let kinds = lines "gltf_properties.txt"

let all_kinds () =
  let sorted = List.sort String.compare in
  let checked = List.map fst Gltf_table.kinds in
  let there = List.filter (fun k -> List.mem k checked) (List.map List.hd kinds) in
  Alcotest.(check (list string)) "no other kinds" (sorted there) (sorted checked)

let check_extension = function
  | name :: kind :: mark :: properties ->
    let at = place kind in
    let add value json = set (at @ [ K "extensions"; K name ]) value json in
    let typed pick =
      let one word = match String.split_on_char ':' word with [ p; t ] -> (p, pick t) | _ -> Alcotest.fail word in
      `Assoc (List.map one properties)
    in
    let with_it = add (typed fitting) whole in
    let what = name ^ " of " ^ kind in
    let () =
      match mark with
      | "still" ->
        still what with_it;
        if List.mem_assoc kind Gltf_table.kinds && kind <> "glTF" then
          Alcotest.(check bool) what true (Gltf_table.extension name = Some Still)
      | "refused" -> refused what at with_it
      | "read" -> refused what at (add (typed wrong) whole)
      | "warned" ->
        let moved = if kind = "goal" then set (goal @ [ K "path" ]) (`String "pointer") with_it else with_it in
        Alcotest.(check string) what "the same SC0324" (show (found moved))
      | other -> Alcotest.fail other
    in
    (match found (set [ K "extensionsRequired" ] (`List [ `String name ]) whole) with
     | Same [] when mark = "still" || mark = "read" -> ()
     | Fault _ -> ()
     | other -> Alcotest.fail (name ^ " required: " ^ show other))
  | _ -> Alcotest.fail "a line of an extension"

(* {1 What is read} *)

let numbers list : json = `List (List.map (fun x -> `Float x) list)
let node name value = set [ K "nodes"; I 0; K name ] value
let hide value = set [ K "nodes"; I 0; K "extensions"; K "KHR_node_visibility"; K "visible" ] (`Bool value)

(* A second node of the scene, ten to the right. *)
let second json =
  let second : json = `Assoc [ ("mesh", `Int 0); ("translation", numbers [ 10.; 0.; 0. ]) ] in
  set [ K "scenes"; I 0; K "nodes" ] (`List [ `Int 0; `Int 1 ])
    (match json with
     | `Assoc members -> (
         match List.assoc "nodes" members with
         | `List [ first ] -> set [ K "nodes" ] (`List [ first; second ]) json
         | _ -> Alcotest.fail "one node")
     | _ -> Alcotest.fail "an object")

let without_data json = remove accessor "sparse" (remove accessor "bufferView" json)
let draco = set (primitive @ [ K "extensions"; K "KHR_draco_mesh_compression" ]) (`Assoc [])
let pointer to_ json =
  set (goal @ [ K "extensions"; K "KHR_animation_pointer"; K "pointer" ]) (`String to_)
    (set (goal @ [ K "path" ]) (`String "pointer") json)

let ( >> ) f g x = g (f x)
let scenes = set [ K "scenes" ] (`List [ `Assoc [ ("nodes", `List [ `Int 0 ]) ]; `Assoc [] ])
let full = "(0, 0, 0) (5/4, 1, 2) solid"
let at_ten = "(10, 0, 0) (45/4, 1, 2) solid"

(* The indices 0 to 11, the first of which is put right. *)
let sparse_indices =
  set [ K "accessors"; I 1; K "sparse" ]
    (`Assoc
       [
         ("count", `Int 1); ("values", `Assoc [ ("bufferView", `Int 1) ]);
         ("indices", `Assoc [ ("bufferView", `Int 1); ("componentType", `Int 5121) ]);
       ])

(* The first bytes of the sparse values are zero: vertex 0 is there twice. *)
let equal_places =
  set (accessor @ [ K "sparse" ])
    (`Assoc
       [
         ("count", `Int 2); ("values", `Assoc [ ("bufferView", `Int 0) ]);
         ("indices", `Assoc [ ("bufferView", `Int 2); ("componentType", `Int 5121) ]);
       ])

let effects =
  [
    ("a scale", node "scale" (numbers [ 2.; 1.; 1. ]), "(0, 0, 0) (5/2, 1, 2) solid");
    ("a mirror", node "scale" (numbers [ -1.; 1.; 1. ]), "(-5/4, 0, 0) (0, 1, 2) solid");
    ("two mirrors", node "scale" (numbers [ -1.; -1.; 1. ]), "(-5/4, -1, 0) (0, 0, 2) solid");
    ("scaled to a point", node "scale" (numbers [ 0.; 0.; 0. ]) >> second, at_ten);
    ("hidden", hide false >> second, at_ten); ("not hidden", hide true, full);
    ("a matrix and a scale",
     node "matrix" (numbers [ 1.; 0.; 0.; 0.; 0.; 1.; 0.; 0.; 0.; 0.; 1.; 0.; 0.; 0.; 0.; 1. ])
     >> node "scale" (numbers [ 1.; 1.; 1. ]),
     "error nodes[0]: the node has a matrix and a scale: one of both is to be removed");
    ("a long quaternion", node "rotation" (numbers [ 0.; 0.; 1.; 1. ]),
     "error nodes[0]: the rotation is no quaternion of length 1");
    ("a morphed mesh", set [ K "meshes"; I 0; K "weights" ] (numbers [ 1. ]), "(0, 0, 0) (5/2, 2, 4) solid");
    ("half morphed", set [ K "meshes"; I 0; K "weights" ] (numbers [ 0.5 ]), "(0, 0, 0) (15/8, 3/2, 3) solid");
    ("weights of the node", node "weights" (numbers [ 2. ]), "(0, 0, 0) (15/4, 3, 6) solid");
    ("too many weights", node "weights" (numbers [ 0.; 0. ]),
     "error meshes[0].primitives[0]: there are 2 weights for 1 targets");
    ("other displacements", set (primitive @ [ K "targets"; I 0; K "POSITION" ]) (`Int 1),
     "error accessors[1]: expected elements of type VEC3, found `SCALAR`");
    ("several scenes", scenes, full ^ " SC0324");
    ("several scenes, one of them the default", scenes >> set [ K "scene" ] (`Int 0), full ^ " SC0324");
    ("no scene", (fun json -> remove [] "scenes" json), full);
    ("a node inside of another, and in the scene",
     second >> set [ K "nodes"; I 1; K "children" ] (`List [ `Int 0 ]),
     "error nodes[0]: the node is in a scene, and inside of another node");
    ("compressed data alone", draco >> without_data,
     "error accessors[0]: its data are compressed (KHR_draco_mesh_compression), and are not in the file as they \
      are");
    ("a stride of indices", set [ K "bufferViews"; I 1; K "byteStride" ] (`Int 4),
     "error bufferViews[1]: indices follow each other, without a stride");
    ("a stride of 0", set [ K "bufferViews"; I 0; K "byteStride" ] (`Int 0),
     "error bufferViews[0]: the stride of a view is a multiple of 4 from 4 to 252, and not 0");
    ("normalized floats", set (accessor @ [ K "normalized" ]) (`Bool true),
     "error accessors[0]: floats (type 5126) are not normalized");
    ("sparse indices", sparse_indices, full);
    ("no sparse values", set (accessor @ [ K "sparse"; K "count" ]) (`Int 0), "(0, 0, 0) (9, 9, 9) no solid");
    ("places that do not increase", equal_places,
     "error accessors[0].sparse.indices: the places of sparse values are to increase");
    ("a later version", set [ K "asset"; K "minVersion" ] (`String "2.1"),
     "error asset: only version 2.0 of glTF is read, not `2.1`");
    ("an animation", set (goal @ [ K "node" ]) (`Int 0), full ^ " SC0324");
    ("an animation of a material", pointer "/materials/0/alphaCutoff", full);
    ("an animation of a node", pointer "/nodes/0/translation", full ^ " SC0324");
  ]

let check_effect (what, change, expected) =
  let text = Yojson.Safe.to_string (change whole) in
  let test () = Alcotest.(check string) what expected (Test_scenes.extent "t.gltf" text) in
  Alcotest.test_case what `Quick test

(* The last index is the greatest of a byte, where so many vertices are. *)
let restart () =
  let json =
    set [ K "buffers"; I 0 ]
      (`Assoc
         [
           ("byteLength", `Int 168);
           ("uri", `String ("data:;base64," ^ Base64.encode_string (String.sub data 0 167 ^ "\255")));
         ])
      whole
    |> set [ K "bufferViews"; I 1; K "byteOffset" ] (`Int 156)
    |> set (accessor @ [ K "count" ]) (`Int 300)
    |> remove accessor "bufferView" |> remove accessor "sparse"
    |> remove primitive "targets"
    |> set [ K "meshes"; I 0; K "weights" ] (`List [])
  in
  match found json with
  | Fault (_, message) when String.starts_with ~prefix:"accessors[1]: the index 255" message -> ()
  | other -> Alcotest.fail (show other)

let twice () =
  let node = "{\"scale\":[1,1,1],\"scale\":[2,2,2]}" in
  match read_text ("{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"nodes\":[" ^ node ^ "]}") with
  | Error d -> Alcotest.(check string) "twice" "an object has the member `scale` twice" d.message
  | Ok _ -> Alcotest.fail "read"

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ( "gltf",
    [
      ( "properties",
        case "the table" all_kinds
        :: List.map (fun row -> case (List.hd row) (fun () -> check_kind (List.hd row) (List.tl row))) kinds );
      ( "extensions",
        List.map (fun row -> case (List.hd row) (fun () -> check_extension row)) (lines "gltf_extensions.txt") );
      ("places", List.map check_effect effects @ [ case "a restart" restart; case "a member twice" twice ]);
    ] )
