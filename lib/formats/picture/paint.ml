open Scc_exact
open Scc_svg

type t = {
  camera : Camera.t;
  origin : Ivec.t;
  canvas : Canvas.t;
  hidden : Hidden.t;
  stroke : float;
  faces : int list array;
  edges : int list array;
}

let by_body count body items =
  let lists = Array.make count [] in
  for i = Array.length items - 1 downto 0 do
    let b = body items.(i) in
    lists.(b) <- i :: lists.(b)
  done;
  lists

(* The mean size of a solid on the paper decides. *)
let stroke_of (canvas : Canvas.t) (view : View.t) =
  let size points =
    let extent f =
      let values = Array.map (fun p -> Rat.near_float (f (canvas.place p))) points in
      Array.fold_left Float.max neg_infinity values -. Array.fold_left Float.min infinity values
    in
    extent fst +. extent snd
  in
  let seen = List.filter (fun points -> Array.length points > 0) (Array.to_list view.points) in
  let sum = List.fold_left (fun sum points -> sum +. size points) 0. seen in
  let mean = sum /. float_of_int (max 1 (List.length seen)) in
  (* What is too far away for floats has no size: then none of the comparisons is true. *)
  if mean < 25. then 0.25 else if mean < 100. then mean /. 100. else 1.

let make camera ~origin canvas hidden =
  let view = Hidden.view hidden in
  let count = Array.length view.points in
  {
    camera;
    origin;
    canvas;
    hidden;
    stroke = stroke_of canvas view;
    faces = by_body count (fun (f : View.face) -> f.body) view.faces;
    edges = by_body count (fun (e : View.edge) -> e.body) view.edges;
  }

(* {1 Points} *)

(* A point of space in the picture, and its depth, if it is in front. *)
let point t p =
  let corner, over = Ivec.of_vec p in
  let seen = match Camera.in_front t.camera over with None -> true | Some height -> Z.sign (height corner) > 0 in
  if not seen then None
  else
    let points = View.points t.camera ~origin:t.origin [| corner |] over in
    Some (points.flat.(0), View.depth points 0)

let place t p = Option.map (fun (at, _) -> t.canvas.place at) (point t p)

let shows t p =
  match point t p with None -> false | Some (at, depth) -> Hidden.shows t.hidden at ~depth

(* {1 Colours} *)

let unit_vector (v : Ivec.t) =
  let greatest = Z.max (Z.abs v.x) (Z.max (Z.abs v.y) (Z.abs v.z)) in
  let part c = Rat.near_float (Rat.make c greatest) in
  let x = part v.x and y = part v.y and z = part v.z in
  let length = sqrt ((x *. x) +. (y *. y) +. (z *. z)) in
  (x /. length, y /. length, z /. length)

let dot (a, b, c) (d, e, f) = (a *. d) +. (b *. e) +. (c *. f)

(* The light comes from the upper left, and a little from whoever looks. *)
let light t (f : View.face) =
  let n = unit_vector f.normal in
  let along axis = dot n (unit_vector axis) in
  (0.75 *. along t.camera.up) -. (0.6 *. along t.camera.right) +. (0.48 *. along t.camera.near)

let shade t base face =
  let l = light t face -. 0.2 in
  if l >= 0. then Palette.mix base Palette.white (0.6 *. l) else Palette.mix base Palette.black (-0.35 *. l)

let ink base = Palette.mix base Palette.black 0.62

(* {1 Shapes} *)

let pixels x = Decimal.fixed ~places:2 (Q.of_float x)

let region t pieces =
  Svg.closed (List.map (List.map t.canvas.place) (Outline.loops pieces))

let lines t segments =
  let place = t.canvas.place in
  Svg.segments (List.map (fun (p, q) -> (place p, place q)) segments)

let none = function [] -> true | _ :: _ -> false

let face t base i =
  match Hidden.pieces t.hidden i with
  | [] -> []
  | pieces ->
    let fill = Palette.hex (shade t base (Hidden.view t.hidden).faces.(i)) in
    (* The stroke of its own colour closes the seam to its neighbours. *)
    Svg.tag "path" [ ("d", region t pieces); ("fill", fill); ("stroke", fill) ] []

(* How much of glass is seen: its faces, and its edges. *)
let face_of_glass = ("opacity", "0.22")
let edge_of_glass = ("opacity", "0.55")

let solid t base body =
  let glass more = if Hidden.is_glass t.hidden body then [ more ] else [] in
  let view = Hidden.view t.hidden in
  let faces = List.concat_map (face t base) t.faces.(body) in
  let outer, inner =
    List.partition
      (fun (e : View.edge) -> Option.is_none e.left || Option.is_none e.right)
      (List.map (fun i -> view.edges.(i)) t.edges.(body))
  in
  let stroked width edges =
    match List.concat_map (Hidden.segments t.hidden) edges with
    | [] -> []
    | segments ->
      let stroke = [ ("stroke", Palette.hex (ink base)); ("stroke-width", pixels width) ] in
      Svg.tag "path" ([ ("d", lines t segments); ("fill", "none") ] @ stroke @ glass edge_of_glass) []
  in
  let edges = stroked (0.8 *. t.stroke) inner @ stroked (1.3 *. t.stroke) outer in
  (if none faces then []
   else Svg.tag "g" ([ ("stroke-width", pixels (0.5 *. t.stroke)) ] @ glass face_of_glass) faces)
  @ edges
