type t = Read | Still | Left_out | Unread of string

let words text = List.filter (fun w -> w <> "") (String.split_on_char ' ' text)
let microsoft = "http://schemas.microsoft.com/3dmanufacturing/"
let core = microsoft ^ "core/2015/02"
let production = microsoft ^ "production/2015/06"
let alternatives = microsoft ^ "production/alternatives/2021/04"
let fullres = "fullres"

(* Colours, names of parts, sets of triangles; and what slicers note about painting. *)
let still =
  [
    microsoft ^ "material/2015/02"; microsoft ^ "trianglesets/2021/07"; alternatives;
    "http://schemas.slic3r.org/3mf/2017/06";
    "http://schemas.bambulab.com/package/2021"; Xmlm.ns_xml; Xmlm.ns_xmlns;
  ]

(* Slices may be finer than the mesh beside them, which need not say so: a file may have a box for its mesh, and a
   sphere in its slices. Namespaces begin with these, whatever their year is. *)
let shapes =
  [
    (microsoft ^ "beamlattice/", "beam lattices"); (microsoft ^ "slice/", "slices");
    (microsoft ^ "volumetric/", "volumetric data"); (microsoft ^ "displacement/", "displacements");
    ("http://schemas.3mf.io/3dmanufacturing/displacement/", "displacements");
    ("http://schemas.3mf.io/3dmanufacturing/volumetric/", "volumetric data");
    ("http://schemas.3mf.io/3dmanufacturing/implicit/", "implicit functions");
    ("http://schemas.3mf.io/3dmanufacturing/booleanoperations/", "Boolean operations");
    (microsoft ^ "booleanoperations/", "Boolean operations"); (microsoft ^ "implicit/", "implicit functions");
    (microsoft ^ "securecontent/", "encrypted parts");
  ]

let begins prefix text =
  let n = String.length prefix in
  String.length text >= n && String.equal (String.sub text 0 n) prefix

let of_extension namespace =
  if List.mem namespace still then Still
  else
    match List.find_opt (fun (prefix, _) -> begins prefix namespace) shapes with
    | Some (_, what) -> Unread what
    | None -> Left_out

let row name read still =
  let all mark text = List.map (fun w -> (w, mark)) (words text) in
  (name, all Read read @ all Still still)

let elements =
  [
    row "model" "resources build" "metadata"; row "resources" "object" "basematerials";
    row "object" "mesh components" "metadatagroup"; row "mesh" "vertices triangles" "";
    row "vertices" "vertex" ""; row "triangles" "triangle" ""; row "components" "component" "";
    row "build" "item" ""; row "vertex" "" ""; row "triangle" "" ""; row "component" "" "";
    row "item" "" "metadatagroup";
  ]

(* The last five of a triangle, and `printable`, are of slicers. *)
let attributes =
  [
    row "model" "unit requiredextensions" "recommendedextensions"; row "resources" "" "";
    row "object" "id type" "thumbnail partnumber name pid pindex"; row "mesh" "" ""; row "vertices" "" "";
    row "triangles" "" ""; row "components" "" ""; row "build" "" ""; row "vertex" "x y z" "";
    row "triangle" "v1 v2 v3"
      "p1 p2 p3 pid paint_color paint_supports paint_seam paint_fuzzy_skin face_property";
    row "component" "objectid transform" ""; row "item" "objectid transform printable" "partnumber";
  ]

let units = words "micron millimeter centimeter inch foot meter"
let types = words "model solidsupport support surface other"

let find table name own =
  let by (key : string) list = Option.map snd (List.find_opt (fun (k, _) -> String.equal k key) list) in
  let*? row = by name table in
  by own row

let find table name own = Option.value (find table name own) ~default:Left_out

let element ~within (namespace, name) =
  if String.equal namespace core then find elements within name
  else if String.equal namespace production then Left_out
  else of_extension namespace

let attribute element (namespace, name) =
  if String.equal namespace "" || String.equal namespace core then find attributes element name
  else if String.equal namespace production then
    if String.equal name "path" && List.mem element [ "component"; "item" ] then Read
    else if String.equal name "UUID" then Still
    else Left_out
  else if String.equal namespace alternatives && String.equal name "modelresolution" then Read
  else if String.equal name "path" && not (List.mem namespace still) then
    Unread "objects in other parts, by an extension that is not known here,"
  else of_extension namespace

let required namespace =
  String.equal namespace core || String.equal namespace production || List.mem namespace still
