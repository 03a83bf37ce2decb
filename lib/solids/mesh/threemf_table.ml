type t = Read | Still | Left_out | Unread of string

let words text = List.filter (fun w -> w <> "") (String.split_on_char ' ' text)
let microsoft = "http://schemas.microsoft.com/3dmanufacturing/"
let core = microsoft ^ "core/2015/02"
let production = microsoft ^ "production/2015/06"

(* Colours, names of parts, sets of triangles; and what slicers note about painting. *)
let still =
  [
    microsoft ^ "material/2015/02"; microsoft ^ "trianglesets/2021/07";
    "http://schemas.3mf.io/3dmanufacturing/alternatives/2021/07"; "http://schemas.slic3r.org/3mf/2017/06";
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

let elements =
  [
    ("model", "resources build", "metadata metadatagroup"); ("resources", "object", "basematerials");
    ("object", "mesh components", "metadatagroup"); ("mesh", "vertices triangles", ""); ("vertices", "vertex", "");
    ("triangles", "triangle", ""); ("components", "component", ""); ("build", "item", ""); ("vertex", "", "");
    ("triangle", "", ""); ("component", "", ""); ("item", "", "metadatagroup");
  ]

let attributes =
  [
    ("model", "unit requiredextensions", "recommendedextensions"); ("resources", "", "");
    ("object", "id type", "thumbnail partnumber name pid pindex"); ("mesh", "", ""); ("vertices", "", "");
    ("triangles", "", ""); ("components", "", ""); ("build", "", ""); ("vertex", "x y z", "");
    ("triangle", "v1 v2 v3", "p1 p2 p3 pid paint_color paint_supports paint_seam paint_fuzzy_skin face_property");
    ("component", "objectid transform", ""); ("item", "objectid transform printable", "partnumber");
  ]

let units = words "micron millimeter centimeter inch foot meter"
let types = words "model solidsupport support surface other"

let find table name own =
  match List.find_opt (fun (n, _, _) -> String.equal n name) table with
  | Some (_, read, _) when List.mem own (words read) -> Read
  | Some (_, _, still) when List.mem own (words still) -> Still
  | Some _ | None -> Left_out

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
  else if String.equal name "path" then Unread "objects in other parts, by an extension that is not known here,"
  else of_extension namespace

let required namespace =
  String.equal namespace core || String.equal namespace production || List.mem namespace still
