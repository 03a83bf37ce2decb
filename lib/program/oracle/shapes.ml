open Scc_base
open Scc_exact
open Scc_geometry
open Scc_json
open Scc_reports

module Pairs = Hashtbl.Make (struct
    type t = int * int

    let equal (a, b) (c, d) = Int.equal a c && Int.equal b d
    let hash (a, b) = (a * 65599) + b
  end)

type store = { shapes : Solid.t Handles.t; mutable made : int; obstacles : Obstacle.t Pairs.t }

let store (q : Quotas.t) =
  {
    shapes = Handles.create ~prefix:"s" ~limit:"shapes" ~most:q.shapes;
    made = 0;
    obstacles = Pairs.create 64;
  }

let shape store = Handles.find store.shapes

(* {1 Obstacles} *)

let most_obstacles = 4096
let forget store = Pairs.reset store.obstacles

let obstacle store (a : Solid.t) (b : Solid.t) =
  let key = (a.id, b.id) in
  match Pairs.find_opt store.obstacles key with
  | Some o -> o
  | None ->
    if Pairs.length store.obstacles >= most_obstacles then forget store;
    let o = Obstacle.make a b in
    Pairs.add store.obstacles key o;
    o

(* All the facets of an obstacle may be as many as the product of the sizes of its two. *)
let large = 10_000

let tidy store (o : Obstacle.t) =
  if Scc_base.Later.is_known o.all && Array.length o.a.vertices * Array.length o.b.vertices > large then
    Pairs.remove store.obstacles (o.a.id, o.b.id)

(* {1 Sets of faces} *)

module Names = Set.Make (String)

let name p at v =
  let s = Read.text p at v and most = (Read.quotas p).name_bytes in
  if String.length s > most then Fault.refuse (Limit ("name_bytes", most));
  if String.length s = 0 then Fault.invalid at "a name is not empty" else s

let names p at ~many v =
  let list = Array.of_list (Read.list name p at v) in
  if Array.length list <> many then Fault.invalid at "%d names are expected" many;
  let add known s = if Names.mem s known then Fault.invalid at "a name is given twice" else Names.add s known in
  ignore (Array.fold_left add Names.empty list);
  list

let default_names letter many = Array.init many (fun i -> letter ^ string_of_int i)

let all_names p ~vertices ~faces =
  let given = Read.optional p "names" Read.fields in
  Option.iter (fun g -> Read.only g [ "vertices"; "faces" ]) given;
  let read member letter many =
    match Option.bind given (fun g -> Read.optional g member (names ~many)) with
    | Some list -> list
    | None -> default_names letter many
  in
  (read "vertices" "v" vertices, read "faces" "f" faces)

let by_name names =
  let table : (string, int) Hashtbl.t = Hashtbl.create 64 in
  Array.iteri (fun i s -> Hashtbl.replace table s i) names;
  table

(* An index may be any integer: what no vertex has is a fault of the shape. *)
let corner table _ at : Wire.t -> int = function
  | Number s when String.length s <= 10 && Option.is_some (int_of_string_opt s) -> int_of_string s
  | Text s -> (
      match Hashtbl.find_opt table s with
      | Some i -> i
      | None -> Fault.invalid at "there is no vertex of this name")
  | _ -> Fault.invalid at "the index or the name of a vertex is expected"

let face_set p : Polyhedron.ifs =
  let q = Read.quotas p in
  let bounded name most = Read.required p name (Read.short_list Read.value ~limit:name ~most) in
  let vertices = bounded "vertices" q.vertices in
  let faces = bounded "faces" q.faces in
  let corners = List.map (fun (f : Wire.t) -> match f with List l -> List.length l | _ -> 0) faces in
  if List.fold_left ( + ) 0 corners > q.corners then Fault.refuse (Limit ("corners", q.corners));
  let vertex_names, face_names =
    all_names p ~vertices:(List.length vertices) ~faces:(List.length faces)
  in
  let table = by_name vertex_names in
  let positions = Read.list Read.vector p (Read.within p "vertices") (List vertices) in
  let cycles = Read.list (Read.list (corner table)) p (Read.within p "faces") (List faces) in
  let set : Polyhedron.ifs =
    {
      ifs_vertices = Array.of_list (List.mapi (fun i v -> (vertex_names.(i), v)) positions);
      ifs_faces = Array.of_list (List.mapi (fun i c -> (face_names.(i), Array.of_list c)) cycles);
    }
  in
  if Polyhedron.too_fine set then Fault.refuse (Limit ("digits", q.digits));
  set

let set_members = [ "vertices"; "faces"; "names"; "limits" ]

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

let linear p =
  match (Read.optional p "linear" Read.matrix, Read.optional p "quaternion" Read.quaternion) with
  | None, None -> Mat.identity
  | None, Some q -> rotation q
  | Some _, Some _ -> Fault.invalid (Member "quaternion") "it does not go with `linear`"
  | Some m, None -> (
      match Rat.sign (Mat.det m) with
      | 0 -> bad_transformation "the linear map is singular"
      | s -> if s > 0 then m else bad_transformation "the linear map is a reflection")

let define store p =
  Read.only p ("linear" :: "quaternion" :: set_members);
  Handles.check_room store.shapes;
  let set = face_set p in
  let map = linear p in
  let report = Solid_report.make set in
  match report.verdict with
  | Rejected _ -> Fault.refuse (Shape_refused (faults report))
  | Accepted (polyhedron, _) ->
    store.made <- store.made + 1;
    let solid = Solid.make ~id:store.made polyhedron map in
    let warnings = List.map (Json_format.write Shape_json.warning) (Solid_report.faults report) in
    let handle = Handles.add store.shapes solid in
    Reply.Value
      (`Assoc
         [
           ("shape", `String handle);
           ("vertices", `Int (Array.length polyhedron.vertices));
           ("edges", `Int (Array.length polyhedron.edges));
           ("faces", `Int (Array.length polyhedron.faces));
           ("volume", Json.rat solid.volume);
           ("centroid", Json.vec solid.centroid);
           ("warnings", `List warnings);
         ])

let check p =
  Read.only p set_members;
  Reply.Value (`Assoc (Json_format.written_members Shape_json.report_members (Solid_report.make (face_set p))))

let matrix (m : Mat.t) = `List [ Json.vec m.r0; Json.vec m.r1; Json.vec m.r2 ]

let mass store p =
  Read.only p [ "shape"; "mass"; "turned"; "at"; "limits" ];
  let solid = Read.required p "shape" (shape store) in
  let mass = Option.value (Read.optional p "mass" Read.positive) ~default:Rat.one in
  let turned = Option.value (Read.optional p "turned" Read.quaternion) ~default:Quaternion.identity in
  let at = Option.value (Read.optional p "at" Read.vector) ~default:Vec.zero in
  let inertia of_mass =
    Scc_rigid.Mass.of_part { body = { Scc_rigid.Placed.solid; turned; at }; mass = of_mass }
  in
  let dense = inertia solid.volume in
  Reply.Value
    (`Assoc
       [
         ("volume", Json.rat solid.volume);
         ("centroid", Json.vec dense.centre);
         ("inertia", matrix dense.inertia);
         ("mass", Json.rat mass);
         ("inertia_of_mass", matrix (inertia mass).inertia);
       ])

(* Obstacles of what is released go, too. *)
let release store p =
  Read.only p [ "shape"; "limits" ];
  let handle = Read.required p "shape" Read.text in
  let (solid : Solid.t) = Handles.release store.shapes handle in
  Pairs.filter_map_inplace
    (fun (a, b) o -> if a = solid.id || b = solid.id then None else Some o)
    store.obstacles;
  Reply.Value (`Assoc [ ("released", `String handle) ])
