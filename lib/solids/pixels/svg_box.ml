open Scc_exact
open Svg_scene

let around_both (a : Aspect.box) (b : Aspect.box) =
  let x = Rat.min a.x b.x and y = Rat.min a.y b.y in
  let right = Rat.max (Rat.add a.x a.width) (Rat.add b.x b.width) in
  let bottom = Rat.max (Rat.add a.y a.height) (Rat.add b.y b.height) in
  { Aspect.x; y; width = Rat.sub right x; height = Rat.sub bottom y }

let union boxes =
  let join found box =
    match (found, box) with None, other | other, None -> other | Some a, Some b -> Some (around_both a b)
  in
  List.fold_left join None boxes

let of_corners corners =
  union (List.map (fun (x, y) -> Some { Aspect.x; y; width = Rat.zero; height = Rat.zero }) corners)

(* [here] is around what the element holds; its style counts, and its place. *)
let rec drawn scene here (node : Svg_tree.node) ~size =
  match Svg_table.element node.name with
  | _ when not here.style.displayed -> None
  | Shape ->
    of_corners (List.concat (Svg_polygon.lines ~budget:scene.corners here.map (Svg_shape.outline here.view node)))
  | Group -> children scene here node
  | Use -> (
      match used scene here node with
      | None -> None
      | Some (inner, ({ name = "symbol"; _ } as target)) ->
        viewport scene (enter scene inner target) target ~size:node
      | Some (inner, target) -> drawn scene (enter scene inner target) target ~size:node)
  | Viewport -> viewport scene here node ~size
  | Silent | Refused _ -> None

and children scene here (node : Svg_tree.node) =
  let child (inner : Svg_tree.node) =
    match Svg_table.element inner.name with
    | Silent | Refused _ -> None
    | Group | Shape | Use | Viewport -> drawn scene (enter scene here inner) inner ~size:inner
  in
  union (List.map child (Svg_switch.children node))

and viewport scene here node ~size =
  if not here.style.displayed then None
  else
    Option.fold (fitted here node (rectangle here node ~size)) ~none:None ~some:(fun inner ->
        children scene inner node)

let user_space scene here node ~size =
  let at = scene.at in
  let scale = Plane_map.stretch here.map in
  let scaled = { here with map = Plane_map.scaling scale scale } in
  let found =
    if Rat.sign scale = 0 then None
    else if node.Svg_tree.name = "symbol" then viewport scene scaled node ~size
    else drawn scene scaled node ~size
  in
  scene.at <- at;
  let back q = Rat.div q scale in
  Option.map
    (fun (b : Aspect.box) ->
       { Aspect.x = back b.x; y = back b.y; width = back b.width; height = back b.height })
    found
