open Scc_exact
module X = Xml_part

let core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"

(* These leave triangles as they are; a part of a model that is elsewhere is told by its path. *)
let harmless =
  [
    core; "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";
  ]

(* {1 What a model says} *)

type mesh = { points : Vec.t array; triangles : (int * int * int) array }
type used = { id : string; place : Affine.t }
type body = Mesh of mesh | Components of used list | Nothing
type thing = { support : bool; other : bool; body : body }

type model = {
  x : X.t;
  path : string;
  things : (string, thing) Hashtbl.t;
  soup : Soup.t;
  mutable budget : int;
}

let is ((namespace, local), _) name = String.equal namespace core && String.equal local name

(* The elements of a name, and what else there is not. *)
let each x name f = X.children x (fun tag -> if is tag name then f tag else X.skip x)

let ok x = function
  | Ok value -> value
  | Error (d : Scc_base.Diag.t) -> X.fail x "%s" d.message

let number m text = ok m.x (Text.coordinate ~path:m.path { text; start = 0 })

let vertices m =
  let found = ref [] in
  let one tag =
    let coordinate name = number m (X.needed m.x tag name) in
    let x = coordinate "x" in
    let y = coordinate "y" in
    let z = coordinate "z" in
    found := Vec.make x y z :: !found;
    X.skip m.x
  in
  each m.x "vertex" one;
  Array.of_list (List.rev !found)

let triangles m ~count =
  let found = ref [] in
  let one tag =
    let corner name = ok m.x (Text.vertex ~path:m.path ~count { text = X.needed m.x tag name; start = 0 }) in
    let a = corner "v1" in
    let b = corner "v2" in
    let c = corner "v3" in
    found := (a, b, c) :: !found;
    X.skip m.x
  in
  each m.x "triangle" one;
  Array.of_list (List.rev !found)

let mesh m =
  let points = ref [||] and faces = ref [||] in
  X.children m.x (fun tag ->
      if is tag "vertices" then points := vertices m
      else if is tag "triangles" then faces := triangles m ~count:(Array.length !points)
      else X.skip m.x);
  Mesh { points = !points; triangles = !faces }

(* Row vectors: (x, y, z, 1) times the matrix, row by row without its last column. *)
let transform m tag =
  match X.attribute tag "transform" with
  | None -> Affine.identity
  | Some text -> (
      let words = String.split_on_char ' ' (String.map (function '\t' | '\n' | '\r' -> ' ' | c -> c) text) in
      match Array.of_list (List.filter (fun w -> w <> "") words) with
      | [| _; _; _; _; _; _; _; _; _; _; _; _ |] as words ->
        let n = Array.map (number m) words in
        let row i = Vec.make n.(i) n.(3 + i) n.(6 + i) in
        { Affine.linear = Mat.make (row 0) (row 1) (row 2); translation = Vec.make n.(9) n.(10) n.(11) }
      | words -> X.fail m.x "a transform has 12 numbers, not %d" (Array.length words))

(* An item or a component. *)
let used m tag =
  let elsewhere ((namespace, local), _) = namespace <> "" && String.equal local "path" in
  if List.exists elsewhere (snd tag) then X.fail m.x "objects in other parts of the package are not read";
  let id = X.needed m.x tag "objectid" in
  if not (Hashtbl.mem m.things id) then X.fail m.x "there is no object %s before this" (Text.quote id);
  let place = transform m tag in
  X.skip m.x;
  { id; place }

let components m =
  let found = ref [] in
  each m.x "component" (fun tag -> found := used m tag :: !found);
  Components (List.rev !found)

let thing m tag =
  let id = X.needed m.x tag "id" in
  if Hashtbl.mem m.things id then X.fail m.x "the object %s is there twice" (Text.quote id);
  let kind = Option.value (X.attribute tag "type") ~default:"model" in
  let body = ref Nothing in
  X.children m.x (fun tag ->
      if is tag "mesh" then body := mesh m else if is tag "components" then body := components m else X.skip m.x);
  let support = String.equal kind "support" || String.equal kind "solidsupport" in
  Hashtbl.add m.things id { support; other = String.equal kind "other"; body = !body }

(* {1 What is built} *)

let spend m n =
  if n > m.budget then
    X.fail m.x "with this the file would have many times the triangles that its size has room for";
  m.budget <- m.budget - n

let max_depth = 1000

(* Each refers to things before it alone, so that this ends. *)
let rec build m depth at { id; place } =
  spend m 1;
  if depth > max_depth then X.fail m.x "components are inside of each other more than %d deep" max_depth;
  let at = Affine.compose at place in
  if Affine.too_long at then X.fail m.x "the numbers of components inside of each other get too long";
  let thing = Hashtbl.find m.things id in
  if thing.other then X.fail m.x "the object %s is of the type `other`, and is not to be built" (Text.quote id);
  if not thing.support then
    match thing.body with
    | Nothing -> ()
    | Components list -> List.iter (build m (depth + 1) at) list
    | Mesh mesh ->
      spend m (Array.length mesh.points + Array.length mesh.triangles);
      let numbers = Array.map (fun v -> Soup.number m.soup (Affine.apply at v)) mesh.points in
      let mirrored = Affine.mirrors at in
      let add (a, b, c) =
        let a = numbers.(a) and b = numbers.(b) and c = numbers.(c) in
        if mirrored then Soup.add m.soup a c b else Soup.add m.soup a b c
      in
      Array.iter add mesh.triangles

let check_required x ((_, attributes) as tag) =
  let one prefix =
    match List.assoc_opt (Xmlm.ns_xmlns, prefix) attributes with
    | Some uri when List.mem uri harmless -> ()
    | Some uri -> X.fail x "the extension %s is not read" (Text.quote uri)
    | None -> X.fail x "the extension %s is not read" (Text.quote prefix)
  in
  let words = String.split_on_char ' ' (Option.value (X.attribute tag "requiredextensions") ~default:"") in
  List.iter one (List.filter (fun w -> w <> "") words)

let model ~path ~size x tag =
  if not (is tag "model") then X.fail x "the element `model` of the core specification is expected";
  check_required x tag;
  let m = { x; path; things = Hashtbl.create 16; soup = Soup.create (); budget = 100_000 + size } in
  let items = ref 0 in
  X.children x (fun tag ->
      if is tag "resources" then each x "object" (thing m)
      else if is tag "build" then
        each x "item" (fun tag ->
            incr items;
            build m 0 Affine.identity (used m tag))
      else X.skip x);
  if !items = 0 then X.fail x "nothing is to be built: there is no item";
  Soup.solid m.soup

(* {1 The package} *)

let relation = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"

(* The name of the part that the package begins with. *)
let first_part x _ =
  let found = ref None in
  X.children x (fun tag ->
      (match (X.attribute tag "Type", X.attribute tag "Target") with
       | Some kind, Some target when String.equal kind relation && Option.is_none !found -> found := Some target
       | _ -> ());
      X.skip x);
  match !found with
  | Some target when String.length target > 0 && target.[0] = '/' -> String.sub target 1 (String.length target - 1)
  | Some target -> target
  | None -> X.fail x "there is no relationship to a 3D model"

let read ~path text =
  let* archive = Archive.read ~path text in
  let part name f =
    let* found = Archive.find archive name in
    match found with
    | None -> Text.error_at ~path 0 "the part %s of the package is missing" (Text.quote name)
    | Some text -> (
        match X.read ~path ~part:(Text.quote name) text (f (String.length text)) with
        | result -> Ok result
        | exception X.Refused d -> Error d)
  in
  let* name = part "_rels/.rels" (fun _ -> first_part) in
  part name (fun size -> model ~path ~size)
