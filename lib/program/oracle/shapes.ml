open Scc_base
open Scc_data
open Scc_exact
open Scc_geometry
open Scc_json
open Scc_runs
open Scc_reports
open Json_format

type store = { shapes : Solid.t Handles.t; mutable made : int; obstacles : Obstacle.t Int_pairs.t }

let store (q : Quotas.t) =
  {
    shapes = Handles.create ~prefix:"s" ~limit:"shapes" ~most:q.shapes;
    made = 0;
    obstacles = Int_pairs.create 64;
  }

let handle = { Read.text with schema = Json_format.schema Answers.shape }
let get store p member = Handles.get store.shapes (Read.required p member)

(* {1 Obstacles} *)

let most_obstacles = 4096
let forget store = Int_pairs.reset store.obstacles

let obstacle store (a : Solid.t) (b : Solid.t) =
  let key = (a.id, b.id) in
  match Int_pairs.find_opt store.obstacles key with
  | Some o -> o
  | None ->
    if Int_pairs.length store.obstacles >= most_obstacles then forget store;
    let o = Obstacle.make a b in
    Int_pairs.add store.obstacles key o;
    o

(* All the facets of an obstacle may be as many as the product of the sizes of its two. *)
let large = 10_000

let tidy store (o : Obstacle.t) =
  if Scc_base.Later.is_known o.all && Array.length o.a.vertices * Array.length o.b.vertices > large then
    Int_pairs.remove store.obstacles (o.a.id, o.b.id)

(* {1 Sets of faces} *)

module Names = Set.Make (String)

let name =
  let named p at s =
    let most = (Read.quotas p).name_bytes in
    if String.length s > most then Fault.refuse (Limit ("name_bytes", most));
    if String.length s = 0 then Fault.invalid at "a name is not empty" else s
  in
  { (Read.map named Read.text) with schema = Text { least = 1 } }

let as_many many at names =
  let list = Array.of_list names in
  if Array.length list <> many then Fault.invalid at "%d names are expected" many;
  let add known s = if Names.mem s known then Fault.invalid at "a name is given twice" else Names.add s known in
  ignore (Array.fold_left add Names.empty list);
  list

let default_names letter many = Array.init many (fun i -> letter ^ string_of_int i)

let vertex_names = Read.member "vertices" (Read.list name)
let face_names = Read.member "faces" (Read.list name)
let names = Read.(member "names" (fields [ may vertex_names; may face_names ]))

let all_names p ~vertices ~faces =
  let given = Read.optional p names in
  let read member letter many =
    let found g = Option.map (as_many many (Read.place g member)) (Read.optional g member) in
    match Option.bind given found with Some list -> list | None -> default_names letter many
  in
  (read vertex_names "v" vertices, read face_names "f" faces)

let by_name names =
  let table : (string, int) Hashtbl.t = Hashtbl.create 64 in
  Array.iteri (fun i s -> Hashtbl.replace table s i) names;
  table

(* An index may be any integer: what no vertex has is a fault of the shape. *)
let corner table =
  let schema = Json_schema.Any_of [ Integer { least = None; most = None }; Text { least = 0 } ] in
  Read.reader schema (fun _ at -> function
      | Number s when String.length s <= 10 && Option.is_some (int_of_string_opt s) -> int_of_string s
      | Text s -> (
          match Hashtbl.find_opt table s with
          | Some i -> i
          | None -> Fault.invalid at "there is no vertex of this name")
      | _ -> Fault.invalid at "the index or the name of a vertex is expected")

let faces_of table = Read.list (Read.list (corner table))

(* They are counted before any of them is read. *)
let vertices =
  let vector = Read.value Read.vector.schema in
  Read.member "vertices" (Read.short_list vector ~limit:"vertices" (fun q -> q.vertices))

let faces =
  let corners = Read.value (Read.list (corner (by_name [||]))).schema in
  Read.member "faces" (Read.short_list corners ~limit:"faces" (fun q -> q.faces))

let face_set p : Polyhedron.ifs =
  let q = Read.quotas p in
  let given_vertices = Read.required p vertices in
  let given_faces = Read.required p faces in
  let corners = List.map (fun (f : Wire.t) -> match f with List l -> List.length l | _ -> 0) given_faces in
  if List.fold_left ( + ) 0 corners > q.corners then Fault.refuse (Limit ("corners", q.corners));
  let vertex_names, face_names =
    all_names p ~vertices:(List.length given_vertices) ~faces:(List.length given_faces)
  in
  let table = by_name vertex_names in
  let positions = (Read.list Read.vector).value p (Read.place p vertices) (List given_vertices) in
  let cycles = (faces_of table).value p (Read.place p faces) (List given_faces) in
  let set : Polyhedron.ifs =
    {
      ifs_vertices = Array.of_list (List.mapi (fun i v -> (vertex_names.(i), v)) positions);
      ifs_faces = Array.of_list (List.mapi (fun i c -> (face_names.(i), Array.of_list c)) cycles);
    }
  in
  if Polyhedron.too_fine set then Fault.refuse (Limit ("digits", q.digits));
  set

let set_members = [ Read.needs vertices; Read.needs faces; Read.may names ]

(* {1 Methods} *)

let faults r =
  match Json_format.write Shape_json.faults r with
  | `List faults -> faults
  | _ -> Bug.fail __POS__ "faults are an array"

let bad_transformation message =
  let fault =
    `Assoc
      [
        ("kind", `String "bad-transformation");
        ("code", `String (Code.bad_transformation :> string));
        ("message", `String message);
        ("hint", `Null);
      ]
  in
  Fault.refuse (Shape_refused [ fault ])

let rotation (q : Quaternion.t) =
  let rational z = Rat.make z Z.one in
  match Mat.of_quaternion (rational q.w, rational q.x, rational q.y, rational q.z) with
  | Some m -> m
  | None -> Bug.fail __POS__ "a rotation of zero"

let linear_map = Read.member "linear" Read.matrix
let quaternion = Read.member "quaternion" Read.quaternion

let linear p =
  match (Read.optional p linear_map, Read.optional p quaternion) with
  | None, None -> Mat.identity
  | None, Some q -> rotation q
  | Some _, Some _ -> Fault.invalid (Member "quaternion") "it does not go with `linear`"
  | Some m, None -> (
      match Rat.sign (Mat.det m) with
      | 0 -> bad_transformation "the linear map is singular"
      | s -> if s > 0 then m else bad_transformation "the linear map is a reflection")

let define =
  let params = set_members @ [ Read.may linear_map; Read.may quaternion; Method.limits ] in
  let part f (_, solid, _) = f solid in
  let count f (_, (solid : Solid.t), _) = f solid.polyhedron in
  let result =
    fields
      [
        field "shape" Answers.shape (fun (handle, _, _) -> handle);
        field "vertices" natural (count (fun p -> Array.length p.vertices));
        field "edges" natural (count (fun p -> Array.length p.edges));
        field "faces" natural (count (fun p -> Array.length p.faces));
        field "volume" Shared.rational (part (fun (s : Solid.t) -> s.volume));
        field "centroid" Shared.vector (part (fun (s : Solid.t) -> s.centroid));
        field "warnings" (list Shape_json.warning) (fun (_, _, warnings) -> warnings);
      ]
  in
  let work store p =
    Handles.check_room store.shapes;
    let set = face_set p in
    let map = linear p in
    let report = Solid_report.make set in
    match report.verdict with
    | Rejected _ -> Fault.refuse (Shape_refused (faults report))
    | Accepted (polyhedron, _) ->
      store.made <- store.made + 1;
      let solid = Solid.make ~id:store.made polyhedron map in
      let handle = Handles.add store.shapes solid in
      (handle, solid, Solid_report.faults report)
  in
  Method.make "shape.define" params result work

let check =
  Method.make "shape.check" (set_members @ [ Method.limits ]) (obj Shape_json.report_members) (fun _ p ->
      Solid_report.make (face_set p))

let of_handle = Read.member "shape" handle

let mass =
  let of_mass = Read.member "mass" Read.positive in
  let turned = Read.member "turned" Read.quaternion and at = Read.member "at" Read.vector in
  let params = Read.[ needs of_handle; may of_mass; may turned; may at; Method.limits ] in
  let dense f (_, m, _) = f m and massive f (_, _, m) = f m in
  let result =
    fields
      [
        field "volume" Shared.rational (fun ((s : Solid.t), _, _) -> s.volume);
        field "centroid" Shared.vector (dense (fun (m : Scc_rigid.Mass.t) -> m.centre));
        field "inertia" Shared.matrix (dense (fun (m : Scc_rigid.Mass.t) -> m.inertia));
        field "mass" Shared.rational (massive (fun (m : Scc_rigid.Mass.t) -> m.mass));
        field "inertia_of_mass" Shared.matrix (massive (fun (m : Scc_rigid.Mass.t) -> m.inertia));
      ]
  in
  let work store p =
    let solid = get store p of_handle in
    let mass = Option.value (Read.optional p of_mass) ~default:Rat.one in
    let turned = Option.value (Read.optional p turned) ~default:Quaternion.identity in
    let at = Option.value (Read.optional p at) ~default:Vec.zero in
    let inertia mass = Scc_rigid.Mass.of_part { body = { Scc_rigid.Placed.solid; turned; at }; mass } in
    (solid, inertia solid.volume, inertia mass)
  in
  Method.make "shape.mass" params result work

(* Obstacles of what is released go, too. *)
let release =
  let work store p =
    let handle = Read.required p of_handle in
    let (solid : Solid.t) = Handles.release store.shapes handle in
    Int_pairs.filter_map_inplace
      (fun (a, b) o -> if a = solid.id || b = solid.id then None else Some o)
      store.obstacles;
    handle
  in
  Method.make "shape.release" [ Read.needs of_handle; Method.limits ] Answers.(released shape) work
