open Scc_exact
open Scc_geometry
open Scc_decompose

type t = {
  face : int;
  plane : Plane.t;
  corners : Homogeneous.t array;
  ids : int array;
  box : Float_box.t;
}

let normal (s : Plane.t) = Ivec.make s.a s.b s.c

(* Some angles may be straight. *)
let plane_of corners =
  let n = Array.length corners in
  let rec from k =
    if k = n then Scc_base.Bug.fail __POS__ "a polygon without an area"
    else
      match Plane.through corners.((k + n - 1) mod n) corners.(k) corners.((k + 1) mod n) with
      | Some plane -> plane
      | None -> from (k + 1)
  in
  from 0

let make ~face ~ids place box =
  let corners = Array.map place ids in
  { face; plane = plane_of corners; corners; ids; box = Float_box.hull (Array.map box ids) }

(* {1 Along an axis} *)

let coordinate axis (p : Homogeneous.t) =
  match (axis : Vec.axis) with X -> (p.near.nx, p.x) | Y -> (p.near.ny, p.y) | Z -> (p.near.nz, p.z)

(* Let u be 2^-53. Both floats have relative errors of 3 u, and the difference one of u: 8 u of the sum of both
   magnitudes bounds the error. Where a number is a NaN, no comparison holds. *)
let along axis (p : Homogeneous.t) (q : Homogeneous.t) =
  let near_p, p' = coordinate axis p and near_q, q' = coordinate axis q in
  let error = 0x1p-50 *. (Float.abs near_p +. Float.abs near_q) in
  if near_p -. near_q > error then 1
  else if near_q -. near_p > error then -1
  else Z.compare (Z.mul p' q.w) (Z.mul q' p.w)

(* That along which a direction goes most. *)
let main_axis (d : Ivec.t) : Vec.axis =
  let less a b = Z.compare (Z.abs a) (Z.abs b) < 0 in
  if less d.x d.y then if less d.y d.z then Z else Y else if less d.x d.z then Z else X

(* The first and the last common point of a plane and a convex polygon, along an axis. *)
let range axis plane corners =
  let n = Array.length corners and found = ref None in
  let add p =
    match !found with
    | None -> found := Some (p, p)
    | Some (a, b) -> found := Some ((if along axis p a < 0 then p else a), if along axis p b > 0 then p else b)
  in
  let sides = Array.map (Plane.side plane) corners in
  for i = 0 to n - 1 do
    let j = (i + 1) mod n in
    if sides.(i) = 0 then add corners.(i);
    if sides.(i) * sides.(j) < 0 then
      let p = corners.(i) and q = corners.(j) in
      add (Homogeneous.crossing p (Plane.height plane p) q (Plane.height plane q))
  done;
  !found

(* {1 Two polygons} *)

type segment = { through : Plane.t; axis : Vec.axis; first : Homogeneous.t; last : Homogeneous.t }

let has sheet id = Array.exists (Int.equal id) sheet.ids

let is_edge sheet u v =
  let n = Array.length sheet.ids in
  let rec from k =
    k < n
    &&
    let a = sheet.ids.(k) and b = sheet.ids.((k + 1) mod n) in
    (a = u && b = v) || (a = v && b = u) || from (k + 1)
  in
  from 0

(* Of s, only corners and edges that t has, too, are where [off] is 0, and what else it has is on one side. *)
let only_shared s t off =
  let n = Array.length s.ids in
  let rec one_side k side =
    k = n
    ||
    let here = off k in
    if here = 0 then has t s.ids.(k) && one_side (k + 1) side else side * here >= 0 && one_side (k + 1) here
  in
  let edge k =
    let l = (k + 1) mod n in
    off k <> 0 || off l <> 0 || is_edge t s.ids.(k) s.ids.(l)
  in
  let rec edges k = k = n || (edge k && edges (k + 1)) in
  one_side 0 0 && edges 0

let reversed corners =
  let n = Array.length corners in
  Array.init n (fun k -> corners.(n - 1 - k))

let share s t =
  let turned = if Plane.equal s.plane t.plane then t.corners else reversed t.corners in
  Planar.share s.plane s.corners turned

(* In one plane, without a common area: some edge of s has t on its other side. *)
let beside_in_plane s t =
  let axis = Planar.axis s.plane and n = Array.length s.corners in
  let facing = Planar.facing s.plane axis in
  let right_of k x = facing * Planar.turn axis s.corners.(k) s.corners.((k + 1) mod n) x in
  let separates k =
    let off l = right_of k t.corners.(l) in
    Array.for_all (fun x -> right_of k x <= 0) t.corners && only_shared t s off
  in
  let rec from k = k < n && (separates k || from (k + 1)) in
  from 0

type contact = Shared | Touching | Crossing of segment * segment | Over

let common_line s t =
  let axis = main_axis (Ivec.cross (normal s.plane) (normal t.plane)) in
  match (range axis t.plane s.corners, range axis s.plane t.corners) with
  | Some (a, b), Some (c, d) when along axis c b <= 0 && along axis a d <= 0 ->
    let corner x p = Array.exists (Homogeneous.equal x) p.corners in
    let one_point x y = Homogeneous.equal x y && corner x s && corner x t in
    if one_point c b || one_point a d then Shared
    else
      let on_s = { through = t.plane; axis; first = c; last = d } in
      Crossing (on_s, { through = s.plane; axis; first = a; last = b })
  | _ -> Shared

let contact s t =
  let off s t k = if has t s.ids.(k) then 0 else Plane.side t.plane s.corners.(k) in
  let aside s t = only_shared s t (off s t) in
  if Plane.equal s.plane t.plane || Plane.equal s.plane (Plane.opposite t.plane) then
    if share s t then Over else if beside_in_plane s t || beside_in_plane t s then Shared else Touching
  else if aside s t || aside t s then Shared
  else common_line s t

(* The edges of another polygon of the same plane. *)
let borders s t =
  let n = Array.length t.corners in
  let edge k =
    let p = t.corners.(k) and q = t.corners.((k + 1) mod n) in
    let part a b = Z.sub (Z.mul b p.w) (Z.mul a q.w) in
    let way = Ivec.make (part p.x q.x) (part p.y q.y) (part p.z q.z) in
    let axis = main_axis way in
    let first, last = if along axis p q < 0 then (p, q) else (q, p) in
    { through = Plane.make (Ivec.cross (normal s.plane) way) p; axis; first; last }
  in
  List.init n edge

(* {1 All} *)

type met = { segments : segment list; over : int list; touched : bool }

let met ~tick sheets =
  let all = Array.map (fun _ -> { segments = []; over = []; touched = false }) sheets in
  let add k segments over =
    let m = all.(k) in
    let segments = List.rev_append segments m.segments and over = List.rev_append over m.over in
    all.(k) <- { segments; over; touched = true }
  in
  let look (i, j) =
    tick ();
    let s = sheets.(i) and t = sheets.(j) in
    match contact s t with
    | Shared -> ()
    | Touching ->
      add i [] [];
      add j [] []
    | Crossing (on_s, on_t) ->
      add i [ on_s ] [];
      add j [ on_t ] []
    | Over ->
      add i (borders s t) [ j ];
      add j (borders t s) [ i ]
  in
  List.iter look (Scc_broad_phase.Boxes.pairs (Array.map (fun s -> s.box) sheets));
  Array.map (fun m -> { m with over = List.sort Int.compare m.over; segments = List.rev m.segments }) all

(* {1 Pieces} *)

type piece = { polygon : Homogeneous.t array; parent : int; leaf : bool }

(* Some inner point of the polygon is in the segment. *)
let cuts polygon s =
  Cell.position s.through polygon = Across
  &&
  match range s.axis s.through polygon with
  | Some (a, b) -> along s.axis s.first b < 0 && along s.axis a s.last < 0
  | None -> false

let rec first_cut polygon = function
  | [] -> None
  | s :: rest -> if cuts polygon s then Some (s.through, rest) else first_cut polygon rest

let pieces ~tick sheet met =
  let found = Scc_data.Growable.create () in
  let rec work = function
    | [] -> ()
    | (parent, polygon, segments) :: waiting -> (
        tick ();
        let number = Scc_data.Growable.length found in
        match first_cut polygon segments with
        | None ->
          Scc_data.Growable.push found { polygon; parent; leaf = true };
          work waiting
        | Some (plane, rest) ->
          Scc_data.Growable.push found { polygon; parent; leaf = false };
          let half plane =
            let reaches s = Plane.side plane s.first < 0 || Plane.side plane s.last < 0 in
            (number, Cell.behind plane polygon, List.filter reaches rest)
          in
          work (half plane :: half (Plane.opposite plane) :: waiting))
  in
  work [ (-1, sheet.corners, met.segments) ];
  Array.init (Scc_data.Growable.length found) (Scc_data.Growable.get found)

(* {1 Points} *)

(* The sum of all four numbers is between two points. *)
let between p q = Homogeneous.crossing p Z.one q Z.minus_one

let inner polygon =
  let n = Array.length polygon in
  let rec from k =
    let p = polygon.(0) and q = polygon.(k) and r = polygon.(k + 1) in
    if k + 2 < n && Option.is_none (Plane.through p q r) then from (k + 1) else between (between p q) r
  in
  from 1

let holds sheet x = Planar.holds sheet.plane sheet.corners x

(* Of edges seen from above, those count that pass y upwards or downwards on the right of the ray. *)
let covers corners x =
  let n = Array.length corners and odd = ref false in
  for i = 0 to n - 1 do
    let a = corners.(i) and b = corners.((i + 1) mod n) in
    let above = along Y a x > 0 in
    if not (Bool.equal above (along Y b x > 0)) then
      let turn = Planar.turn Z a b x in
      if if above then turn < 0 else turn > 0 then odd := not !odd
  done;
  !odd

let over sheet x =
  let up = Z.sign sheet.plane.c in
  if up * Plane.side sheet.plane x < 0 && covers sheet.corners x then up else 0

let on_line a b x = Planar.turn X a b x = 0 && Planar.turn Y a b x = 0 && Planar.turn Z a b x = 0

let farther a b x y =
  let rec along_some : Vec.axis list -> int = function
    | [] -> 0
    | axis :: rest -> ( match along axis b a with 0 -> along_some rest | way -> way * along axis x y)
  in
  along_some [ X; Y; Z ]

let on_edge a b x = on_line a b x && farther a b a x < 0 && farther a b x b < 0
