open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

type t = {
  faces : (Ast.name * Ast.vector) list * (Ast.name * Ast.name list) list;
  others : (Ast.name * Region.t) list;
}

(* What a point is: told by its numbers, or as it is written. *)
type place = Known of Vec.t | Written of Ast.expr

let same a b =
  match (a, b) with
  | Known v, Known w -> Vec.equal v w
  | Written e, Written f -> String.equal (Text.expr e) (Text.expr f)
  | Known _, Written _ | Written _, Known _ -> false

let place plain e = match Plain.vector plain e with Ok v -> Known v | Error _ -> Written e
let known = function Known v -> Some v | Written _ -> None

let rec distinct seen = function
  | [] -> List.rev seen
  | (p, e) :: rest ->
    if List.exists (fun (q, _) -> same p q) seen then distinct seen rest else distinct ((p, e) :: seen) rest

(* A table by coordinates, where all are known: solids may have thousands of points. *)
module Places = Hashtbl.Make (struct
    type t = Vec.t

    let equal = Vec.equal
    let hash = Vec.hash
  end)

let all_known points =
  let seen = Places.create 64 in
  List.filter
    (fun (v, _) ->
       let fresh = not (Places.mem seen v) in
       if fresh then Places.add seen v ();
       fresh)
    points

(* How the corners are found among the points: an index, if it is one. *)
let index_of points =
  match Array.map (fun (p, _) -> known p) points with
  | vs when Array.for_all Option.is_some vs ->
    let table = Places.create 64 in
    Array.iteri (fun i v -> Option.iter (fun v -> Places.replace table v i) v) vs;
    (function Known v -> Places.find_opt table v | Written _ -> None)
  | _ ->
    fun p ->
      let rec from i =
        if i = Array.length points then None else if same p (fst points.(i)) then Some i else from (i + 1)
      in
      from 0

(* The faces of the hull, as indices of points. *)
let hull at points =
  let named = Array.mapi (fun i (p, _) -> (string_of_int i, Option.value (known p) ~default:Vec.zero)) points in
  match Scc_mesh.Hull_of.named (Array.to_list named) with
  | None -> Fault.refuse Code.no_solid at "these points span no solid: all of them are in one plane"
  | Some h ->
    let index v = int_of_string (fst h.ifs_vertices.(v)) in
    let faces = Array.map (fun (_, c) -> Array.map index c) h.ifs_faces in
    (Array.map (fun (n, _) -> int_of_string n) h.ifs_vertices, faces)

let fresh prefix taken at count =
  let rec from names i left =
    let name = Printf.sprintf "%s%d" prefix i in
    if left = 0 then List.rev names
    else if Hashtbl.mem taken name then from names (i + 1) left
    else from (Tree.at at name :: names) (i + 1) (left - 1)
  in
  from [] 1 count

let key corners =
  let sorted = Array.copy corners in
  Array.sort Int.compare sorted;
  Array.to_list sorted

(* The points of a solid, its corners and faces where they are known, and which of them have names so far. *)
type reading = {
  plain : Plain.t;
  exact : bool;  (** all points are known numbers, so that corners and faces are those of the hull *)
  points : (place * Ast.expr) array;
  index : place -> int option;
  is_corner : bool array;
  faces : int array array;
  by_corners : (int list, int) Hashtbl.t;  (** faces by their sorted corners *)
  names : Ast.name option array;  (** of points *)
  listed : bool array;  (** faces that have a name *)
  mutable found : (Ast.name * int array) list;  (** faces with names, the last one first *)
}

let start plain ~at written =
  let placed = List.map (fun e -> (place plain e, e)) written in
  let exact = List.for_all (fun (p, _) -> Option.is_some (known p)) placed in
  let points =
    if exact then
      List.map (fun (p, e) -> (Option.value (known p) ~default:Vec.zero, e)) placed
      |> all_known
      |> List.map (fun (v, e) -> (Known v, e))
    else distinct [] placed
  in
  let points = Array.of_list points in
  let size = Array.length points in
  let corners, faces = if exact then hull at points else (Array.init size Fun.id, [||]) in
  let is_corner = Array.make size false in
  Array.iter (fun i -> is_corner.(i) <- true) corners;
  let by_corners = Hashtbl.create 16 in
  Array.iteri (fun i c -> Hashtbl.replace by_corners (key c) i) faces;
  {
    plain; exact; points; index = index_of points; is_corner; faces; by_corners;
    names = Array.make size None;
    listed = Array.make (Array.length faces) false;
    found = [];
  }

(* Names a corner. False if the point is none, or has a name. *)
let name_vertex r name p =
  match r.index (place r.plain p) with
  | Some i when r.is_corner.(i) && Option.is_none r.names.(i) ->
    r.names.(i) <- Some name;
    true
  | Some _ | None -> false

(* Names a face of the hull by its corners in either direction. False if they are none in order, or it has a name.
*)
let name_hull_face r name cycle =
  match Hashtbl.find_opt r.by_corners (key cycle) with
  | Some i when not r.listed.(i) ->
    let n = Array.length cycle in
    let turned = Array.init n (fun k -> cycle.(n - 1 - k)) in
    let is c = Polyhedron.rotation_equivalent c r.faces.(i) in
    let right = if is cycle then Some cycle else if is turned then Some turned else None in
    let add c =
      r.listed.(i) <- true;
      r.found <- (name, c) :: r.found
    in
    Option.iter add right;
    Option.is_some right
  | Some _ | None -> false

let name_face r name ps =
  let cycle = List.map (fun p -> r.index (place r.plain p)) ps in
  if not (List.for_all Option.is_some cycle) then false
  else
    let cycle = Array.of_list (List.filter_map Fun.id cycle) in
    if r.exact then name_hull_face r name cycle
    else begin
      r.found <- (name, cycle) :: r.found;
      true
    end

let is_feature r (name, (x : Region.t)) =
  match x.kind with
  | Point p -> name_vertex r name p
  | Polygon ps -> name_face r name ps
  | _ -> false

let indices array = List.init (Array.length array) Fun.id

let read plain ~at written regions =
  let r = start plain ~at written in
  let _, others = List.partition (is_feature r) regions in
  let taken = Hashtbl.create 16 in
  List.iter (fun ((n : Ast.name), _) -> Hashtbl.replace taken n.it ()) regions;
  let corners = List.filter (fun i -> r.is_corner.(i)) (indices r.points) in
  let unnamed = List.filter (fun i -> Option.is_none r.names.(i)) corners in
  List.iter2 (fun i n -> r.names.(i) <- Some n) unnamed (fresh "v" taken at (List.length unnamed));
  let name i = Option.value r.names.(i) ~default:(Tree.at at "") in
  let missing = List.filter (fun i -> not r.listed.(i)) (indices r.faces) in
  let more = List.map2 (fun i n -> (n, r.faces.(i))) missing (fresh "f" taken at (List.length missing)) in
  let with_corners (n, c) = (n, List.map name (Array.to_list c)) in
  {
    faces =
      (List.map (fun i -> (name i, snd r.points.(i))) corners, List.map with_corners (List.rev r.found @ more));
    others;
  }
