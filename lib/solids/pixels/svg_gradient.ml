open Scc_exact
open Svg_number

let stop tree ~style (node : Svg_tree.node) =
  let value name = List.assoc_opt name (List.rev (Svg_tree.declared tree node)) in
  let colour =
    match Option.map Css_colour.paint (value "stop-color") with
    | None -> Rat.one
    | Some (Colour c) -> c.alpha
    | Some Current -> (style node).Svg_style.colour.alpha
    | Some (Nothing | Server _) -> raise (Bad "a stop-color that is no colour")
  in
  let opacity = Option.fold (value "stop-opacity") ~none:Rat.one ~some:Svg_style.share in
  Rat.mul colour opacity

let rec stops (tree : Svg_tree.t) seen (node : Svg_tree.node) =
  if List.memq node seen then raise (Bad "a gradient that refers to itself");
  match List.filter (fun (inner : Svg_tree.node) -> inner.name = "stop") node.children with
  | _ :: _ as found -> found
  | [] -> (
      match Svg_tree.href node with
      | None | Some "" -> []
      | Some target when target.[0] <> '#' ->
        raise (Unread (Printf.sprintf "the reference %S to another file" target))
      | Some target -> (
          match Hashtbl.find_opt tree.ids (String.sub target 1 (String.length target - 1)) with
          | Some ({ name = "linearGradient" | "radialGradient"; _ } as other) -> stops tree (node :: seen) other
          | _ -> raise (Bad (Printf.sprintf "the reference %S to no gradient" target))))

let opacity tree ~style node =
  match List.map (stop tree ~style) (stops tree [] node) with
  | [] -> None
  | first :: rest ->
    let widen (low, high) q = (Rat.min low q, Rat.max high q) in
    Some (List.fold_left widen (first, first) rest)
