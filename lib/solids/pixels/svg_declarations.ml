open Svg_number

let lower value =
  if String.exists (fun c -> c = '(' || c = '"' || c = '\'') value then value else String.lowercase_ascii value

let refuse kind name cure = raise (Unread (Printf.sprintf "the %s %S: %s" kind name cure))

(* A property with one value that changes nothing has no other one. *)
let kept kind (name, value) =
  match List.assoc_opt name Svg_table.harmless with
  | None -> Some (name, value)
  | Some harmless when String.equal value harmless -> None
  | Some _ -> refuse kind (name ^ ": " ^ value) "remove it, or apply it to the shapes"

let of_attribute element (name, value) =
  match Svg_table.attribute element name with
  | Still -> None
  | Unread cure -> refuse "attribute" name cure
  | Read -> (
      match Svg_table.property name with
      | Read -> kept "attribute" (name, lower (String.trim value))
      | Still | Unread _ -> None)

let check_point (d : Css.declaration) =
  if Css.ends_with_point d.value then
    raise (Bad (Printf.sprintf "a number that ends with a point: %S" d.value))

let of_declaration (d : Css.declaration) =
  match Svg_table.property d.property with
  | Still -> None
  | Unread cure -> refuse "property" d.property cure
  | Read ->
    check_point d;
    let css = function ("transform" | "transform-origin") as name -> "css " ^ name | name -> name in
    Option.map (fun (name, value) -> (css name, value)) (kept "property" (d.property, lower d.value))

let of_element ~valid element attributes ~sheet =
  let style =
    match List.assoc_opt "style" attributes with None -> [] | Some text -> Css.declarations ~valid text
  in
  let important, others = List.partition (fun (d : Css.declaration) -> d.important) (sheet @ style) in
  List.filter_map (of_attribute element) attributes @ List.filter_map of_declaration (others @ important)
