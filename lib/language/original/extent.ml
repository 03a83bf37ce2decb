open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

type round = Flat | Ball | About_axis

type solid = {
  polyhedron : Polyhedron.t;
  round : round;
  plain : Plain.t;
  declared : string -> Region.t option;
  face_planes : Pieces.plane array;
}

type t =
  | Feature of Feature.t
  | Interior of Feature.t
  | Polygon of int * Vec.t array  (* in this face *)
  | Segment of Vec.t * Vec.t
  | Point of Vec.t
  | Half of Pieces.plane
  | Faces of int list
  | Whole
  | Empty
  | Union of t * t
  | Common of t * t
  | Less of t * t

(* {1 Places} *)

let face_plane (p : Polyhedron.t) (_, c) : Pieces.plane =
  let place v = snd p.vertices.(v) in
  let a = place c.(0) and b = place c.(1) in
  let normal = Vec.cross (Vec.sub b a) (Vec.sub (place c.(2)) b) in
  { normal; offset = Vec.dot normal a }

let solid ~plain ~declared round polyhedron =
  { polyhedron; round; plain; declared; face_planes = Array.map (face_plane polyhedron)
                                            polyhedron.Polyhedron.faces }

let place s v = snd s.polyhedron.vertices.(v)
let plane s f = s.face_planes.(f)

let height (p : Pieces.plane) x = Rat.sub (Vec.dot p.normal x) p.offset
let on (p : Pieces.plane) x = Rat.sign (height p x) = 0
let face_numbers s = List.init (Array.length s.polyhedron.faces) Fun.id

(* The faces in which all these points are, which are points of the solid. *)
let faces_with s points = List.filter (fun f -> List.for_all (on (plane s f)) points) (face_numbers s)
let within s x = List.for_all (fun f -> Rat.sign (height (plane s f) x) <= 0) (face_numbers s)
let on_surface s x = List.exists (fun f -> on (plane s f) x) (face_numbers s)

(* {1 From what is written} *)

let not_plain at =
  Fault.refuse Code.unknown_points at
    "a region that has to be cut out of a shape needs plain numbers, and this is none"
    ~hint:"write it with numbers and constants (`let`); a parameter may have another value in each run"

let vector s e = match Plain.vector s.plain e with Ok v -> v | Error at -> not_plain at
let number s e = match Plain.number s.plain e with Ok q -> q | Error at -> not_plain at

let on_one_face s at points =
  let stray = List.find_opt (fun x -> not (within s x && on_surface s x)) points in
  match (stray, faces_with s points) with
  | Some x, _ -> Fault.refuse Code.off_surface at "the point %s is not on the surface of the shape"
                   (Vec.to_string x)
  | None, [] -> Fault.refuse Code.off_surface at "these points are not on one face of the shape"
  | None, face :: _ -> face

(* Two coordinates that tell the points of a plane apart. *)
let flat (p : Pieces.plane) (x : Vec.t) =
  if Rat.sign p.normal.z <> 0 then (x.x, x.y) else if Rat.sign p.normal.y <> 0 then (x.z, x.x) else (x.y, x.z)

let turn (ax, ay) (bx, by) (cx, cy) =
  Rat.sign (Rat.sub (Rat.mul (Rat.sub bx ax) (Rat.sub cy ay)) (Rat.mul (Rat.sub by ay) (Rat.sub cx ax)))

let between a b x = Rat.compare (Rat.min a b) x <= 0 && Rat.compare x (Rat.max a b) <= 0
let on_side (ax, ay) (bx, by) (x, y) = turn (ax, ay) (bx, by) (x, y) = 0 && between ax bx x && between ay by y

let sides_meet a b c d =
  (turn a b c * turn a b d < 0 && turn c d a * turn c d b < 0)
  || on_side a b c || on_side a b d || on_side c d a || on_side c d b

let is_simple corners =
  let n = Array.length corners in
  let corner i = corners.(i mod n) in
  let pairs i =
    List.for_all
      (fun j ->
         let a = corner i and b = corner (i + 1) and c = corner j and d = corner (j + 1) in
         if j = i + 1 then not (on_side a b d || on_side c d a)
         else if i = 0 && j = n - 1 then not (on_side a b c || on_side c d b)
         else not (sides_meet a b c d))
      (List.init (n - i - 1) (fun k -> i + k + 1))
  in
  List.for_all pairs (List.init n Fun.id)

let same_point (ax, ay) (bx, by) = Rat.equal ax bx && Rat.equal ay by

let polygon s at corners =
  let points = List.map (vector s) corners in
  let face = on_one_face s at points in
  let flats = Array.of_list (List.map (flat (plane s face)) points) in
  let n = Array.length flats in
  let repeated = List.exists (fun i -> same_point flats.(i) flats.((i + 1) mod n)) (List.init n Fun.id) in
  if repeated || not (is_simple flats) then
    Fault.refuse Code.bad_region at "the sides of this polygon meet elsewhere than at its corners"
      ~hint:"list its corners in order, each once; a region with a hole is a difference, X - Y";
  Polygon (face, Array.of_list points)

let unknown s at name =
  let names =
    Array.to_list (Array.map fst s.polyhedron.faces) @ Array.to_list (Array.map fst s.polyhedron.vertices)
  in
  Fault.refuse Code.unknown_feature at "the shape has no feature or region `%s`" name ?hint:(Diag.suggest
                                                                                               name names)

let vertex s (name : Ast.name) =
  match Polyhedron.find_vertex s.polyhedron name.it with
  | Some v -> v
  | None -> unknown s name.at name.it

let single (p : Ast.path) =
  match p.it with
  | [ { name; indices = [] } ] -> name
  | _ ->
    Fault.refuse Code.bad_region p.at "a region of a shape that is cut is told without names of bodies or \
                                       indices"

let hull s at paths =
  let corners = Array.of_list (List.map (fun p -> vertex s (single p)) paths) in
  let n = Array.length corners in
  let turned = Array.init n (fun i -> corners.(n - 1 - i)) in
  let found =
    match corners with
    | [| v |] -> Some (Feature.Vertex v)
    | [| v; w |] -> Option.map (fun e -> Feature.Edge e) (Polyhedron.find_edge s.polyhedron v w)
    | _ -> (
        match (Polyhedron.find_cycle s.polyhedron corners, Polyhedron.find_cycle s.polyhedron turned) with
        | Some f, _ | None, Some f -> Some (Feature.Face f)
        | None, None -> None)
  in
  match found with
  | Some f -> Feature f
  | None -> Fault.refuse Code.unknown_feature at "these are not the corners of a feature of the shape"

(* {1 Caps} *)

let cap s at axis c =
  let v = vector s axis and cosine = number s c in
  let flattened (x : Vec.t) = match s.round with About_axis -> Vec.make x.x x.y Rat.zero | Ball | Flat -> x in
  if Rat.sign cosine < 0 || Rat.compare cosine Rat.one >= 0 then
    Fault.refuse Code.bad_region c.Ast.at "the cosine of a cap is at least 0 and less than 1"
      ~hint:"more than a half is what a cap leaves: `surface() - cap(v, c)`";
  let level = match s.round with About_axis -> Rat.sign v.z = 0 | Ball | Flat -> true in
  (match s.round with
   | Flat -> Fault.refuse Code.bad_region at "a cap is of a sphere, a cylinder or a cone"
   | Ball | About_axis ->
     if Vec.is_zero v || not level then
       Fault.refuse Code.bad_region axis.Ast.at "this is no direction from the axis"
         ~hint:"about the axis of a cylinder or cone a direction has no z");
  let inside x =
    let x = flattened x in
    let along = Vec.dot v x in
    let bound = Rat.mul (Rat.mul cosine cosine) (Rat.mul (Vec.norm2 v) (Vec.norm2 x)) in
    Vec.is_zero x || (Rat.sign along >= 0 && Rat.compare (Rat.mul along along) bound >= 0)
  in
  let facet f =
    let name, corners = s.polyhedron.faces.(f) in
    let is_base = match name with "top" | "bottom" -> true | _ -> false in
    let of_curve = match s.round with About_axis -> not is_base | Ball | Flat -> true in
    of_curve && Array.for_all (fun k -> inside (place s k)) corners
  in
  Faces (List.filter facet (face_numbers s))

(* {1 Regions} *)

let most_parts = 1_000

let rec region s left (x : Region.t) =
  decr left;
  if !left < 0 then
    Fault.refuse Code.too_deep x.at "a region is made of more than %d others, or of itself" most_parts;
  let inner = region s left in
  match x.kind with
  | Named p -> (
      let name = single p in
      match s.declared name.it with
      | Some x -> inner x
      | None -> (
          match Polyhedron.find_face s.polyhedron name.it with
          | Some f -> Feature (Face f)
          | None -> Feature (Vertex (vertex s name))))
  | Hull corners -> hull s x.at corners
  | Interior y -> (
      match inner y with
      | Feature f -> Interior f
      | _ -> Fault.refuse Code.bad_region x.at "`interior` is of a single feature")
  | Polygon corners -> polygon s x.at corners
  | Segment (p, q) ->
    let p = vector s p and q = vector s q in
    ignore (on_one_face s x.at [ p; q ]);
    if Vec.equal p q then Point p else Segment (p, q)
  | Point p ->
    let p = vector s p in
    ignore (on_one_face s x.at [ p ]);
    Point p
  | Half (n, d) ->
    let normal = vector s n in
    if Vec.is_zero normal then Fault.refuse Code.bad_region n.at "the normal of a half-space is not zero";
    Half { normal; offset = number s d }
  | Cap (v, c) -> cap s x.at v c
  | Whole -> Whole
  | Empty -> Empty
  | Union (y, z) -> Union (inner y, inner z)
  | Common (y, z) -> Common (inner y, inner z)
  | Less (y, z) -> Less (inner y, inner z)

let resolve s x = region s (ref most_parts) x

(* {1 Cuts} *)

let through normal x : Pieces.plane = { normal; offset = Vec.dot normal x }
let normal_of s f = (plane s f).normal

(* Along a side of a polygon in a face, upright on it; none where it lies along an edge of the solid. *)
let upright s face p q =
  if List.length (faces_with s [ p; q ]) > 1 then []
  else [ through (Vec.cross (normal_of s face) (Vec.sub q p)) p ]

let of_polygon s face corners =
  let n = Array.length corners in
  List.concat_map (fun i -> upright s face corners.(i) corners.((i + 1) mod n)) (List.init n Fun.id)

(* The end of a segment, unless it is where the segment comes to the end of its face or edge. *)
let ends s faces p q =
  let crosswise x = if List.length (faces_with s [ x ]) > List.length faces then [] else [ through (Vec.sub q
                                                                                                      p) x ] in
  crosswise p @ crosswise q

let of_segment s p q =
  match faces_with s [ p; q ] with
  | [ face ] -> upright s face p q @ ends s [ face ] p q
  | faces -> ends s faces p q

let of_point s x =
  match faces_with s [ x ] with
  | [ f ] ->
    let _, c = s.polyhedron.faces.(f) in
    let d = Vec.sub (place s c.(1)) (place s c.(0)) in
    [ through d x; through (Vec.cross (normal_of s f) d) x ]
  | [ f; g ] -> [ through (Vec.cross (normal_of s f) (normal_of s g)) x ]
  | _ -> []

let rec planes s = function
  | Feature _ | Interior _ | Faces _ | Whole | Empty -> []
  | Polygon (face, corners) -> of_polygon s face corners
  | Segment (p, q) -> of_segment s p q
  | Point x -> of_point s x
  | Half p -> [ p ]
  | Union (y, z) | Common (y, z) | Less (y, z) -> List.append (planes s y) (planes s z)

(* {1 Points} *)

let in_polygon (p : Pieces.plane) corners x =
  let flats = Array.map (flat p) corners and px, py = flat p x in
  let n = Array.length flats in
  let inside = ref false and on_it = ref false in
  for i = 0 to n - 1 do
    let (ax, ay) as a = flats.(i) and ((bx, by) as b) = flats.((i + 1) mod n) in
    if on_side a b (px, py) then on_it := true;
    if not (Bool.equal (Rat.compare ay py > 0) (Rat.compare by py > 0)) then begin
      let across = Rat.add ax (Rat.div (Rat.mul (Rat.sub py ay) (Rat.sub bx ax)) (Rat.sub by ay)) in
      if Rat.compare px across < 0 then inside := not !inside
    end
  done;
  !on_it || !inside

let in_feature s f x =
  match (f : Feature.t) with
  | Vertex v -> Vec.equal x (place s v)
  | Face f -> on (plane s f) x
  | Edge e ->
    let { Topology.left; right; _ } = s.polyhedron.topology.edges.(e) in
    on (plane s left) x && on (plane s right) x

(* Of no feature of a lower dimension: a point is in as many faces as meet in the feature that it is inside of. *)
let in_interior s f x =
  in_feature s f x
  &&
  match (f : Feature.t) with
  | Vertex _ -> true
  | Edge _ -> List.compare_length_with (faces_with s [ x ]) 2 = 0
  | Face _ -> List.compare_length_with (faces_with s [ x ]) 1 = 0

let in_segment p q x =
  let d = Vec.sub q p and e = Vec.sub x p in
  let along = Vec.dot d e in
  Vec.is_zero (Vec.cross d e) && Rat.sign along >= 0 && Rat.compare along (Vec.norm2 d) <= 0

let rec contains s r x =
  match r with
  | Feature f -> in_feature s f x
  | Interior f -> in_interior s f x
  | Polygon (face, corners) -> on (plane s face) x && in_polygon (plane s face) corners x
  | Segment (p, q) -> in_segment p q x
  | Point p -> Vec.equal p x
  | Half p -> Rat.sign (height p x) >= 0
  | Faces fs -> List.exists (fun f -> on (plane s f) x) fs
  | Whole -> true
  | Empty -> false
  | Union (y, z) -> contains s y x || contains s z x
  | Common (y, z) -> contains s y x && contains s z x
  | Less (y, z) -> contains s y x && not (contains s z x)
