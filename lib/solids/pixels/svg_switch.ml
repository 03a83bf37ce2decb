open Svg_number

let unread name value =
  raise (Unread (Printf.sprintf "the attribute %S: what %S shows depends on the reader: remove it" name value))

(* Browsers take every feature as given, also of those that they do not draw. *)
let is_feature text =
  List.exists (fun prefix -> String.starts_with ~prefix text) [ "http://www.w3.org/TR/SVG"; "org.w3c." ]

let filled text = List.filter (( <> ) "") (words text)

let holds (name, value) =
  match (name, filled value) with
  | "requiredExtensions", _ :: _ -> false
  | "requiredFeatures", (_ :: _ as features) when List.for_all is_feature features -> true
  | _ -> unread name value

let chosen (node : Svg_tree.node) =
  let conditions (inner : Svg_tree.node) =
    List.partition (fun (name, _) -> Svg_table.is_condition name) inner.attributes
  in
  let rec go = function
    | [] -> []
    | (inner : Svg_tree.node) :: rest -> (
        match Svg_table.element inner.name with
        | Silent -> go rest
        | Group | Shape | Use | Viewport | Refused _ ->
          let asked, attributes = conditions inner in
          (* One that does not hold decides, whatever the others say. *)
          let extensions, others = List.partition (fun (name, _) -> name = "requiredExtensions") asked in
          if List.for_all holds extensions && List.for_all holds others then [ { inner with attributes } ]
          else go rest)
  in
  go node.children

let children (node : Svg_tree.node) = if node.name = "switch" then chosen node else node.children
