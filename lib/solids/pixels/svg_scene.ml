open Scc_exact
open Svg_number

let max_drawn = 100_000
let max_area = 1 lsl 29

type scene = {
  tree : Svg_tree.t;
  raster : Raster.t;
  corners : Svg_polygon.budget;
  mutable layer : Svg_layer.t;  (** what is painted on *)
  mutable fading : ((int * int) * string) option;  (** a gradient whose opacity is not the same everywhere *)
  mutable blended : (int * int) option;  (** the first element whose colours are mixed *)
  mutable drawn : int;  (** how many elements *)
  mutable area : int;  (** how many pixels were looked at *)
  mutable at : int * int;  (** the place of the element that is being drawn *)
}

type around = {
  style : Svg_style.t;
  map : Plane_map.t;
  clip : Bytes.t option;
  view : Svg_shape.view;
  depth : int;
  used : Svg_tree.node list;
}

let look scene n =
  scene.area <- scene.area + n;
  if scene.area > max_area then
    raise (Beyond (Printf.sprintf "%d pixels to paint, each counted once for each area" max_area))

let inside scene rule polygons f =
  let { Raster.width; height; _ } = scene.raster in
  look scene (Fill.cost ~width ~height polygons);
  Fill.inside ~width ~height rule polygons f

let count scene =
  scene.drawn <- scene.drawn + 1;
  if scene.drawn > max_drawn then
    raise (Beyond (Printf.sprintf "%d elements to draw, each counted where it is used" max_drawn))

let enter scene around (node : Svg_tree.node) =
  scene.at <- node.at;
  count scene;
  if around.depth >= Svg_tree.max_depth then raise (Bad "elements nested too deep");
  let properties = Svg_tree.declared scene.tree node in
  let style = Svg_style.of_properties around.style properties in
  if style.own.blended && scene.blended = None then scene.blended <- Some node.at;
  let own = Svg_transform.of_properties ~size:(around.view.width, around.view.height) properties in
  { around with style; map = Plane_map.compose around.map own; depth = around.depth + 1 }

(* {1 References} *)

let referred scene text =
  if text = "" then None
  else if text.[0] <> '#' then raise (Unread (Printf.sprintf "the reference %S to another file" text))
  else
    match Hashtbl.find_opt scene.tree.ids (String.sub text 1 (String.length text - 1)) with
    | Some node -> Some node
    | None -> raise (Bad (Printf.sprintf "the reference %S to no element" text))

let using here (node : Svg_tree.node) =
  if List.memq node here.used then raise (Bad "an element that uses itself");
  { here with used = node :: here.used }

let number node read view name ~default =
  match Svg_tree.attribute node name with None | Some "auto" -> default | Some text -> read view text

let used scene here node =
  let target = referred scene (String.trim (Option.value (Svg_tree.href node) ~default:"")) in
  let at read name = number node read here.view name ~default:Rat.zero in
  let x = at Svg_shape.across "x" in
  let y = at Svg_shape.down "y" in
  let place target = ({ (using here target) with map = Plane_map.(compose here.map (translation x y)) }, target) in
  Option.map place target

(* {1 Viewports} *)

let rectangle here node ~size =
  let at read name ~default = number node read here.view name ~default in
  let side read name whole = number size read here.view name ~default:(at read name ~default:whole) in
  let x = at Svg_shape.across "x" ~default:Rat.zero in
  let y = at Svg_shape.down "y" ~default:Rat.zero in
  let width = side Svg_shape.across "width" here.view.width in
  let height = side Svg_shape.down "height" here.view.height in
  if Rat.sign width < 0 || Rat.sign height < 0 then raise (Bad "a viewport with a negative side");
  { Aspect.x; y; width; height }

let fitted here node (inside : Aspect.box) =
  let box = Option.map Aspect.box (Svg_tree.attribute node "viewBox") in
  let empty (b : Aspect.box) = Rat.sign b.width = 0 || Rat.sign b.height = 0 in
  match box with
  | _ when empty inside -> None
  | Some b when empty b -> None
  | Some b ->
    let map = Aspect.fit (Svg_tree.attribute node "preserveAspectRatio") ~inside b in
    Some { here with map = Plane_map.compose here.map map; view = { width = b.width; height = b.height } }
  | None ->
    let map = Plane_map.translation inside.x inside.y in
    let view = { Svg_shape.width = inside.width; height = inside.height } in
    Some { here with map = Plane_map.compose here.map map; view }
