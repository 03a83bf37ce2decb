open Scc_exact
open Svg_number
open Svg_scene

let within clip k = match clip with None -> true | Some mask -> Bytes.get mask k <> '\000'

let mask scene =
  let n = Bytes.length scene.raster.alphas in
  look scene n;
  Bytes.make n '\000'

let add scene found clip rule polygons =
  inside scene rule polygons (fun k -> if within clip k then Bytes.set found k '\001')

(* The style that a clip path inherits, where it stands. *)
let rec style_above scene (node : Svg_tree.node) =
  match node.parent with
  | None -> Svg_style.initial
  | Some parent -> { (style_at scene parent) with displayed = true }

and style_at scene node =
  count scene;
  Svg_style.of_properties (style_above scene node) (Svg_tree.declared scene.tree node)

(* The units of a clip path: those of what it clips, or the box around this. *)
let units scene here (node : Svg_tree.node) ~size (path : Svg_tree.node) =
  match Svg_tree.attribute path "clipPathUnits" with
  | None | Some "userSpaceOnUse" -> Some Plane_map.identity
  | Some "objectBoundingBox" ->
    if node.parent = None || node.name = "clipPath" then
      raise (Unread "a clip path in units of what it clips, for a whole drawing or a clip path");
    let map (b : Aspect.box) =
      if Rat.sign b.width = 0 || Rat.sign b.height = 0 then
        raise (Unread "a clip path in units of what has no width or no height");
      Plane_map.(compose (translation b.x b.y) (scaling b.width b.height))
    in
    Option.map map (Svg_box.user_space scene here node ~size)
  | Some other -> raise (Bad (Printf.sprintf "the clipPathUnits %S" other))

let rec clipped ?size scene here (node : Svg_tree.node) =
  match here.style.own.clip with
  | Some id when here.style.displayed -> (
      match Hashtbl.find_opt scene.tree.ids id with
      | Some ({ name = "clipPath"; _ } as path) -> (
          match units scene here node ~size:(Option.value size ~default:node) path with
          | None -> here
          | Some units -> { here with clip = Some (clip_path scene here path ~units) })
      | _ -> raise (Bad (Printf.sprintf "the reference \"#%s\" to no clip path" id)))
  | Some _ | None -> here

and clip_path scene here path ~units =
  let at = scene.at in
  let inner = enter scene { (using here path) with style = style_above scene path } path in
  let inner = { (clipped scene inner path) with map = Plane_map.compose inner.map units } in
  let found = mask scene in
  List.iter (clip_piece scene inner found) path.children;
  scene.at <- at;
  found

and clip_piece scene around found (node : Svg_tree.node) =
  let here () = clipped scene (enter scene around node) node in
  if Svg_table.element node.name = Shape then begin
    let here = here () in
    if here.style.displayed && here.style.shown then
      Svg_polygon.filled ~budget:scene.corners here.map (Svg_shape.outline here.view node)
      |> add scene found here.clip here.style.clip_rule
  end
  else if node.name = "use" then
    match used scene (here ()) node with
    | None -> ()
    | Some (here, target) when Svg_table.element target.name = Shape -> clip_piece scene here found target
    | Some _ -> raise (Unread "a use of what is no shape in a clip path")
  else raise (Unread (Printf.sprintf "the element %S in a clip path" node.name))
