open Scc_exact
open Svg_number

let stop tree ~style (node : Svg_tree.node) =
  let value name ~default read =
    match List.assoc_opt name (List.rev (Svg_tree.declared tree node)) with
    | None | Some ("initial" | "unset") -> default
    | Some ("inherit" as word) -> raise (Unread (Printf.sprintf "the value %S of %s" word name))
    | Some text -> read text
  in
  let alpha text =
    match Css_colour.paint text with
    | Colour c -> c.alpha
    | Current -> (style node).Svg_style.colour.alpha
    | Nothing | Server _ -> raise (Bad "a stop-color that is no colour")
  in
  Svg_tree.at node (fun () ->
      Rat.mul (value "stop-color" ~default:Rat.one alpha) (value "stop-opacity" ~default:Rat.one share))

(* The gradient and those that it refers to, the nearest first. *)
let rec chain (tree : Svg_tree.t) seen (node : Svg_tree.node) =
  if List.memq node seen then raise (Bad "a gradient that refers to itself");
  match Svg_tree.href node with
  | None | Some "" -> List.rev (node :: seen)
  | Some target when target.[0] <> '#' ->
    raise (Unread (Printf.sprintf "the reference %S to another file" target))
  | Some target -> (
      match Hashtbl.find_opt tree.ids (String.sub target 1 (String.length target - 1)) with
      | Some ({ name = "linearGradient" | "radialGradient"; _ } as other) -> chain tree (node :: seen) other
      | _ -> raise (Bad (Printf.sprintf "the reference %S to no gradient" target)))

let stops (node : Svg_tree.node) = List.filter (fun (inner : Svg_tree.node) -> inner.name = "stop") node.children

(* {1 Where it paints} *)

(* Beyond a cone around the focus nothing is painted. *)
let check_focus chain ~view ~own_units =
  let radial = List.filter (fun (node : Svg_tree.node) -> node.name = "radialGradient") chain in
  let given name = List.find_map (fun node -> Svg_tree.attribute node name) radial in
  let value along name ~default =
    match given name with
    | None -> default
    | Some text when own_units -> length ~whole:Rat.one text
    | Some text -> along view text
  in
  let middle whole = if own_units then Rat.half else Rat.mul Rat.half whole in
  let cx = value Svg_shape.across "cx" ~default:(middle view.Svg_shape.width) in
  let cy = value Svg_shape.down "cy" ~default:(middle view.height) in
  let along _ text = Svg_shape.along view text in
  let r = value along "r" ~default:(if own_units then Rat.half else along view "50%") in
  if Rat.sign r < 0 then raise (Bad "a gradient with a negative radius");
  let x = Rat.sub (value Svg_shape.across "fx" ~default:cx) cx in
  let y = Rat.sub (value Svg_shape.down "fy" ~default:cy) cy in
  let room = Rat.sub r (value along "fr" ~default:Rat.zero) in
  let beyond () = Rat.compare (Rat.add (Rat.mul x x) (Rat.mul y y)) (Rat.mul room room) >= 0 in
  if Rat.sign r > 0 && (Rat.sign room <= 0 || beyond ()) then
    raise (Unread "a radial gradient whose focus is not within its circle")

(* A gradient in units of what has no width or no height is ignored. *)
let is_ignored chain ~view ~box =
  let given name = List.find_map (fun node -> Svg_tree.attribute node name) chain in
  let own_units =
    match given "gradientUnits" with
    | None | Some "objectBoundingBox" -> true
    | Some "userSpaceOnUse" -> false
    | Some other -> raise (Bad (Printf.sprintf "the gradientUnits %S" other))
  in
  (match List.hd chain with
   | { Svg_tree.name = "radialGradient"; _ } -> check_focus chain ~view ~own_units
   | _ -> ());
  let map = Option.fold (given "gradientTransform") ~none:Plane_map.identity ~some:Svg_transform.of_text in
  if not (Plane_map.is_invertible map) then raise (Unread "a gradient that is scaled to nothing");
  own_units
  &&
  match box () with
  | Some (b : Aspect.box) -> Rat.sign b.width = 0 || Rat.sign b.height = 0
  | None -> true

let opacity tree ~style ~view ~box node =
  let chain = chain tree [] node in
  match Option.value (List.find_opt (function [] -> false | _ -> true) (List.map stops chain)) ~default:[] with
  | [] -> Svg_style.Unseen
  | _ when Svg_tree.at node (fun () -> is_ignored chain ~view ~box) -> Ignored
  | first :: rest ->
    let first = stop tree ~style first in
    let widen (low, high) q = (Rat.min low q, Rat.max high q) in
    let low, high = List.fold_left widen (first, first) (List.map (stop tree ~style) rest) in
    Between (low, high)
