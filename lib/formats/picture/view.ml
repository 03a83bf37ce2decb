open Scc_exact
open Scc_rigid

type solid = { corners : Ivec.t array; denominator : Z.t; faces : int array array; edges : (int * int) array }

let of_placed (p : Placed.t) =
  let corners, denominator = Placed.integers p in
  let polyhedron = p.solid.polyhedron in
  { corners; denominator; faces = Array.map snd polyhedron.faces; edges = polyhedron.edges }

type face = {
  body : int;
  face : int;
  polygon : Convex.t;
  sides : Ivec.t array;
  depth : Ivec.t;
  scale : Z.t;
  normal : Ivec.t;
}

type edge = { body : int; edge : int; ends : Ivec.t * Ivec.t; left : face option; right : face option }

type t = { faces : face array; edges : edge array; points : Ivec.t array array }

type points = { world : Ivec.t array; turned : Ivec.t array; flat : Ivec.t array; over : Z.t }

let points camera ~origin corners over =
  let from = Ivec.scale over origin in
  let world = Array.map (fun p -> Ivec.sub p from) corners in
  let turned = Array.map (Camera.turn camera) world in
  let flat = Array.map (fun (p : Ivec.t) -> Convex.point p.x p.y over) turned in
  { world; turned; flat; over }

let normal points corners =
  let at i = points.(corners.(i)) in
  Ivec.primitive (Ivec.cross (Ivec.sub (at 1) (at 0)) (Ivec.sub (at 2) (at 0)))

(* With the axes of the camera for axes, the plane of a face is n . p = n . c, for a corner c. Solved for the
   depth, over the denominator of the corners. *)
let facing ~body ~face p corners =
  let n = normal p.turned corners in
  if Z.sign n.z <= 0 then None
  else
    let polygon = Array.map (fun c -> p.flat.(c)) corners in
    let over = Z.neg p.over in
    let depth = Ivec.make (Z.mul over n.x) (Z.mul over n.y) (Ivec.dot n p.turned.(corners.(0))) in
    let scale = Z.mul p.over n.z in
    let sides = Convex.sides polygon in
    Some { body; face; polygon; sides; depth; scale; normal = normal p.world corners }

let depth p i = Rat.make p.turned.(i).Ivec.z p.over

(* For each directed side of a face that is seen, the face. Seen from outside the face is to the left of it, and so
   it is in the picture. *)
let beside (solid : solid) faces =
  let table = Hashtbl.create 16 in
  let add f =
    let corners = solid.faces.(f.face) in
    let n = Array.length corners in
    Array.iteri (fun i v -> Hashtbl.replace table (v, corners.((i + 1) mod n)) f) corners
  in
  List.iter add faces;
  Hashtbl.find_opt table

let see camera ~origin body (solid : solid) =
  let p = points camera ~origin solid.corners solid.denominator in
  let face i corners = facing ~body ~face:i p corners in
  let faces = List.filter_map Fun.id (Array.to_list (Array.mapi face solid.faces)) in
  let beside = beside solid faces in
  let edge i (v, w) =
    match (beside (v, w), beside (w, v)) with
    | None, None -> None
    | left, right -> Some { body; edge = i; ends = (p.flat.(v), p.flat.(w)); left; right }
  in
  (faces, List.filter_map Fun.id (Array.to_list (Array.mapi edge solid.edges)), p.flat)

let make camera ~origin solids =
  let all = Array.to_list (Array.mapi (see camera ~origin) solids) in
  {
    faces = Array.of_list (List.concat_map (fun (f, _, _) -> f) all);
    edges = Array.of_list (List.concat_map (fun (_, e, _) -> e) all);
    points = Array.of_list (List.map (fun (_, _, p) -> p) all);
  }

let nearer f g = Ivec.sub (Ivec.scale g.scale f.depth) (Ivec.scale f.scale g.depth)

let depth_at f (p : Ivec.t) = Rat.make (Ivec.dot f.depth p) (Z.mul f.scale p.z)
let before f p depth = Rat.compare (depth_at f p) depth
