open Scc_exact
open Scc_rigid

type solid = Front.mesh = {
  corners : Ivec.t array;
  denominator : Z.t;
  faces : int array array;
  edges : (int * int) array;
}

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

type points = { world : Ivec.t array; turned : Ivec.t array; flat : Ivec.t array; over : Z.t; perspective : bool }

let points (camera : Camera.t) ~origin corners over =
  let from, over, times =
    match camera.eye with
    | None -> (Ivec.scale over origin, over, Z.one)
    | Some eye ->
      let at, d = Ivec.of_vec eye.at in
      (Ivec.scale over at, Z.mul over d, d)
  in
  let world = Array.map (fun p -> Ivec.sub (Ivec.scale times p) from) corners in
  let turned = Array.map (Camera.turn camera) world in
  let behind (p : Ivec.t) = if Option.is_none camera.eye then over else Z.neg p.z in
  let flat = Array.map (fun (p : Ivec.t) -> Convex.point p.x p.y (behind p)) turned in
  { world; turned; flat; over; perspective = Option.is_some camera.eye }

let normal points corners =
  let at i = points.(corners.(i)) in
  Ivec.primitive (Ivec.cross (Ivec.sub (at 1) (at 0)) (Ivec.sub (at 2) (at 0)))

(* With the axes of the camera for axes, the plane of a face is n . p = h for the height h = n . c of a corner
   c. Solved for the depth, over the denominator of the corners. For an eye, which is at the origin, a point (x,
   y, z) is at (x, y) / -z of the picture, and the depth is 1 / -z: the plane divided by h z. *)
let depths p (n : Ivec.t) height =
  if p.perspective then
    let over = p.over in
    (Ivec.make (Z.neg (Z.mul over n.x)) (Z.neg (Z.mul over n.y)) (Z.mul over n.z), Z.neg height)
  else
    let over = Z.neg p.over in
    (Ivec.make (Z.mul over n.x) (Z.mul over n.y) height, Z.mul p.over n.z)

let facing ~body ~face p corners =
  if Array.length corners < 3 then None
  else
    let n = normal p.turned corners in
    let depth, scale = depths p n (Ivec.dot n p.turned.(corners.(0))) in
    if Z.sign scale <= 0 then None
    else
      let polygon = Array.map (fun c -> p.flat.(c)) corners in
      let sides = Convex.sides polygon in
      Some { body; face; polygon; sides; depth; scale; normal = normal p.world corners }

let depth p i =
  let z = p.turned.(i).Ivec.z in
  if p.perspective then Rat.make p.over (Z.neg z) else Rat.make z p.over

(* For each directed side of a face that is seen, the face. Seen from outside the face is to the left of it, and
   so it is in the picture. *)
let beside (solid : solid) faces =
  let table = Hashtbl.create 16 in
  let add f =
    let corners = solid.faces.(f.face) in
    let n = Array.length corners in
    Array.iteri (fun i v -> Hashtbl.replace table (v, corners.((i + 1) mod n)) f) corners
  in
  List.iter add faces;
  Hashtbl.find_opt table

(* What is seen of a solid, if any of it is in front. *)
let in_front camera (solid : solid) =
  match Camera.in_front camera solid.denominator with
  | None -> Some solid
  | Some height -> Front.part ~height solid

let no_solid = { corners = [||]; denominator = Z.one; faces = [||]; edges = [||] }

let see camera ~origin body solid =
  let solid = Option.value (in_front camera solid) ~default:no_solid in
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
