open Scc_exact
module X = Xml_part
module T = Threemf_table

(* {1 What a model says} *)

type mesh = { points : Vec.t array; triangles : (int * int * int) array }

type body = Mesh of mesh | Components of used list | Nothing
and thing = { support : bool; other : bool; body : body }
and used = { id : string; thing : thing; place : Affine.t }

(* The parts that have been read, each with its objects; [None] while it is read. *)
type package = {
  path : string;
  archive : Archive.t;
  parts : (string, (string, thing) Hashtbl.t option) Hashtbl.t;
  soup : Soup.t;
  mutable budget : int;
  mutable depth : int;  (* of parts that are read because of others *)
  mutable unit_ : string option;  (* of the first part *)
  mutable left_out : Scc_base.Diag.t option;
  mutable flat : Scc_base.Diag.t option;  (* of a triangle without area *)
}

type model = { x : X.t; path : string; package : package; things : (string, thing) Hashtbl.t }

let leave_out ?(hint = "nothing has to be done if it makes no shapes") m what =
  if Option.is_none m.package.left_out then
    m.package.left_out <-
      Some
        (Scc_base.Diag.warning Scc_base.Code.mesh_left_out (Scc_base.Span.of_file m.path) ~hint "%s" what)

let leave_out_unknown m what = leave_out m (what ^ " is left out: it is not known here")

let leave_out_support m id =
  leave_out m ~hint:"nothing has to be done if it is made for printing alone"
    (Printf.sprintf "the object %s is a support, and is left out" (Text.quote id))

(* It has no area, so that a solid is the same without it. *)
let leave_out_flat m =
  if Option.is_none m.package.flat then
    m.package.flat <-
      Some
        (Scc_base.Diag.warning Scc_base.Code.mesh_left_out (Scc_base.Span.of_file m.path)
           "%s: a triangle has two equal corners, and is left out" (X.place m.x))

let refuse m what = X.fail m.x "%s are not read: export the model as triangles alone" what

let check_attributes m ((_, element), attributes) =
  let one (name, _) =
    match T.attribute element name with
    | Read | Still -> ()
    | Left_out -> leave_out_unknown m (Printf.sprintf "the attribute %s of `%s`" (Text.quote (snd name)) element)
    | Unread what -> refuse m what
  in
  List.iter one attributes

(* Calls for each element that is read, inside of one of this name. *)
let each m within f =
  X.children m.x (fun ((name, _) as tag) ->
      match T.element ~within name with
      | Read ->
        check_attributes m tag;
        f (snd name) tag
      | Still -> X.skip m.x
      | Left_out ->
        leave_out_unknown m (Printf.sprintf "the element %s in `%s`" (Text.quote (snd name)) within);
        X.skip m.x
      | Unread what -> refuse m what)

let none m within = each m within (fun _ _ -> X.skip m.x)

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
    none m "vertex"
  in
  each m "vertices" (fun _ -> one);
  Array.of_list (List.rev !found)

let triangles m ~count =
  let found = ref [] in
  let one tag =
    let corner name = ok m.x (Text.vertex ~path:m.path ~count { text = X.needed m.x tag name; start = 0 }) in
    let a = corner "v1" in
    let b = corner "v2" in
    let c = corner "v3" in
    if a = b || b = c || c = a then leave_out_flat m;
    found := (a, b, c) :: !found;
    none m "triangle"
  in
  each m "triangles" (fun _ -> one);
  Array.of_list (List.rev !found)

(* Calls as {!each} does; none of the elements may be there twice. *)
let each_once m within f =
  let seen = ref [] in
  each m within (fun name tag ->
      if List.mem name !seen then X.fail m.x "the element %s is in `%s` twice" (Text.quote name) within;
      seen := name :: !seen;
      f name tag)

let mesh m =
  let points = ref [||] and faces = ref [||] in
  each_once m "mesh" (fun name _ ->
      if String.equal name "vertices" then points := vertices m
      else faces := triangles m ~count:(Array.length !points));
  Mesh { points = !points; triangles = !faces }

(* A positive integer; numbers that begin with zeros are the same without them. *)
let id_of m tag name =
  let text = X.needed m.x tag name in
  let rest = ref 0 in
  while !rest < String.length text - 1 && text.[!rest] = '0' do incr rest done;
  if text = "" || not (String.for_all (fun c -> c >= '0' && c <= '9') text) then
    X.fail m.x "`%s` is to be an integer, and not %s" name (Text.quote text);
  String.sub text !rest (String.length text - !rest)

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

(* {1 Objects, in this part and in others} *)

let max_depth = 1000
let max_parts = 32

let rec things_of package x name =
  let key = String.lowercase_ascii name in
  match Hashtbl.find_opt package.parts key with
  | Some (Some things) -> things
  | Some None -> X.fail x "the part %s is used inside of itself" (Text.quote name)
  | None -> (
      if package.depth >= max_parts then X.fail x "parts name each other more than %d deep" max_parts;
      match ok x (Archive.find package.archive name) with
      | None -> X.fail x "the part %s of the package is missing" (Text.quote name)
      | Some text ->
        Hashtbl.replace package.parts key None;
        package.depth <- package.depth + 1;
        package.budget <- package.budget + String.length text;
        let m = X.read ~path:package.path ~part:(Text.quote name) text (model package ~built:(fun _ -> X.skip)) in
        package.depth <- package.depth - 1;
        Hashtbl.replace package.parts key (Some m.things);
        m.things)

(* An item or a component. *)
and used m tag =
  let id = id_of m tag "objectid" in
  let things =
    match List.assoc_opt (T.production, "path") (snd tag) with
    | None -> m.things
    | Some name when String.length name > 0 && name.[0] = '/' ->
      things_of m.package m.x (String.sub name 1 (String.length name - 1))
    | Some name -> X.fail m.x "the path of a part begins with a slash, and not as %s" (Text.quote name)
  in
  let place = transform m tag in
  match Hashtbl.find_opt things id with
  | None -> X.fail m.x "there is no object %s before this" (Text.quote id)
  | Some thing -> { id; thing; place }

and components m =
  let found = ref [] in
  each m "components" (fun _ tag ->
      found := used m tag :: !found;
      none m "component");
  Components (List.rev !found)

and thing m tag =
  let id = id_of m tag "id" in
  if Hashtbl.mem m.things id then X.fail m.x "the object %s is there twice" (Text.quote id);
  let kind = Option.value (X.attribute tag "type") ~default:"model" in
  if not (List.mem kind T.types) then X.fail m.x "%s is no type of an object" (Text.quote kind);
  (match List.assoc_opt (T.alternatives, "modelresolution") (snd tag) with
   | Some other when not (String.equal other T.fullres) ->
     X.fail m.x "the object %s is not meant to be made: its resolution is %s" (Text.quote id) (Text.quote other)
   | Some _ | None -> ());
  let body = ref Nothing in
  each m "object" (fun name _ ->
      (match !body with
       | Nothing -> ()
       | Mesh _ | Components _ -> X.fail m.x "the object %s has two shapes" (Text.quote id));
      body := if String.equal name "mesh" then mesh m else components m);
  let support = String.equal kind "support" || String.equal kind "solidsupport" in
  Hashtbl.add m.things id { support; other = String.equal kind "other"; body = !body }

and check_required x ((_, attributes) as tag) =
  let one prefix =
    match List.assoc_opt (Xmlm.ns_xmlns, prefix) attributes with
    | Some uri when T.required uri -> ()
    | Some uri -> X.fail x "the extension %s is not read" (Text.quote uri)
    | None -> X.fail x "the extension %s is not read" (Text.quote prefix)
  in
  let words = String.split_on_char ' ' (Option.value (X.attribute tag "requiredextensions") ~default:"") in
  List.iter one (List.filter (fun w -> w <> "") words)

(* One part; [built] reads its list of what is to be built. *)
and model package ~built x (((namespace, name), _) as tag) =
  if not (String.equal namespace T.core && String.equal name "model") then
    X.fail x "the element `model` of the core specification is expected";
  check_required x tag;
  let m = { x; path = package.path; package; things = Hashtbl.create 16 } in
  check_attributes m tag;
  let own = Option.value (X.attribute tag "unit") ~default:"millimeter" in
  if not (List.mem own T.units) then X.fail x "%s is no unit of 3MF" (Text.quote own);
  (match package.unit_ with
   | None -> package.unit_ <- Some own
   | Some other when String.equal own other -> ()
   | Some other ->
     X.fail x "this part is in the unit %s, and the first part in %s" (Text.quote own) (Text.quote other));
  each_once m "model" (fun name _ ->
      if String.equal name "resources" then each m "resources" (fun _ -> thing m) else built m x);
  m

(* {1 What is built} *)

let spend m n =
  if n > m.package.budget then
    X.fail m.x "with this the file would have many times the triangles that its size has room for";
  m.package.budget <- m.package.budget - n

(* Each refers to things before it alone, so that this ends. *)
let rec build m depth at { id; thing; place } =
  spend m 1;
  if depth > max_depth then X.fail m.x "components are inside of each other more than %d deep" max_depth;
  let at = Affine.compose at place in
  if Rat.sign (Mat.det at.Affine.linear) = 0 then X.fail m.x "the transform makes everything flat";
  if Affine.too_long at then X.fail m.x "the numbers of components inside of each other get too long";
  if thing.other then X.fail m.x "the object %s is of the type `other`, and is not to be built" (Text.quote id);
  if thing.support then leave_out_support m id
  else
    match thing.body with
    | Nothing -> ()
    | Components list -> List.iter (build m (depth + 1) at) list
    | Mesh mesh ->
      spend m (Array.length mesh.points + Array.length mesh.triangles);
      let soup = m.package.soup in
      let numbers = Array.map (fun v -> Soup.number soup (Affine.apply at v)) mesh.points in
      let mirrored = Affine.mirrors at in
      let add (a, b, c) =
        let a = numbers.(a) and b = numbers.(b) and c = numbers.(c) in
        if mirrored then Soup.add soup a c b else Soup.add soup a b c
      in
      Array.iter add mesh.triangles

let build_items items m _ =
  each m "build" (fun _ tag ->
      incr items;
      (match X.attribute tag "printable" with
       | Some ("1" | "true") | None -> ()
       | Some _ -> X.fail m.x "an item that is not to be printed: remove it, or make it printable");
      build m 0 Affine.identity (used m tag);
      none m "item")

let root package x tag =
  let items = ref 0 in
  ignore (model package ~built:(build_items items) x tag);
  if !items = 0 then X.fail x "nothing is to be built: there is no item";
  let set = Soup.solid package.soup in
  if Array.length set.ifs_vertices = 0 then
    X.fail x "nothing that is built has a mesh%s"
      (Option.fold ~none:"" ~some:(fun (d : Scc_base.Diag.t) -> ": " ^ d.message) package.left_out);
  set

(* {1 The package} *)

let relation = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"

(* The name of the part that the package begins with. *)
let first_part x _ =
  let found = ref None in
  X.children x (fun tag ->
      (match (X.attribute tag "Type", X.attribute tag "Target") with
       | Some kind, Some target when String.equal kind relation ->
         if Option.is_some !found then X.fail x "the package begins with two models";
         found := Some target
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
  let package =
    {
      path; archive; parts = Hashtbl.create 16; soup = Soup.create (); budget = 100_000; depth = 0; unit_ = None;
      left_out = None; flat = None;
    }
  in
  Hashtbl.replace package.parts (String.lowercase_ascii name) None;
  let first size =
    package.budget <- package.budget + size;
    root package
  in
  let* set = part name first in
  Ok (set, Option.to_list package.left_out @ Option.to_list package.flat)
