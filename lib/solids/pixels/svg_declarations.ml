open Svg_number

(* Comments of CSS end where they are closed, and the last one at the end. *)
let without_comments text =
  let n = String.length text in
  let b = Buffer.create n in
  let rec go i inside =
    if i < n then
      let two = if i + 1 < n then String.sub text i 2 else "" in
      if inside then if two = "*/" then go (i + 2) false else go (i + 1) true
      else if two = "/*" then begin Buffer.add_char b ' '; go (i + 2) true end
      else begin Buffer.add_char b text.[i]; go (i + 1) false end
  in
  go 0 false;
  Buffer.contents b

(* Parts between semicolons that are in no brackets and no quotes. *)
let parts text =
  let n = String.length text in
  let rec go i start depth quote found =
    if i >= n then List.rev (String.sub text start (n - start) :: found)
    else
      match (text.[i], quote) with
      | c, Some q -> go (i + 1) start depth (if c = q then None else quote) found
      | ('"' | '\''), None -> go (i + 1) start depth (Some text.[i]) found
      | '(', None -> go (i + 1) start (depth + 1) None found
      | ')', None -> go (i + 1) start (max 0 (depth - 1)) None found
      | ';', None when depth = 0 -> go (i + 1) (i + 1) 0 None (String.sub text start (i - start) :: found)
      | _, None -> go (i + 1) start depth None found
  in
  go 0 0 0 None []

let lower value =
  if String.exists (fun c -> c = '(' || c = '"' || c = '\'') value then value else String.lowercase_ascii value

type declaration = { name : string; value : string; important : bool }

let declaration part =
  match String.index_opt part ':' with
  | None -> if String.trim part = "" then None else raise (Bad (Printf.sprintf "the style %S" (String.trim part)))
  | Some i ->
    let name = String.lowercase_ascii (String.trim (String.sub part 0 i)) in
    let value = String.trim (String.sub part (i + 1) (String.length part - i - 1)) in
    if String.contains part '\\' then raise (Unread "a style with escapes (\\)");
    let mark = "important" in
    let n = String.length value and k = String.length mark in
    let important =
      n > k && String.lowercase_ascii (String.sub value (n - k) k) = mark
      && String.contains value '!'
      && String.trim (String.sub value (String.index value '!' + 1) (n - String.index value '!' - 1 - k)) = ""
    in
    let value = if important then String.trim (String.sub value 0 (String.index value '!')) else value in
    Some { name; value = lower value; important }

let refuse kind name cure = raise (Unread (Printf.sprintf "the %s %S: %s" kind name cure))

(* A property with one value that changes nothing has no other one. *)
let kept kind (name, value) =
  match List.assoc_opt name Svg_table.harmless with
  | None -> Some (name, value)
  | Some harmless when String.equal value harmless -> None
  | Some _ when name = "vector-effect" && value = "non-scaling-stroke" -> None
  | Some _ -> refuse kind (name ^ ": " ^ value) "remove it, or apply it to the shapes"

let of_attribute element (name, value) =
  match Svg_table.attribute element name with
  | Still -> None
  | Unread cure -> refuse "attribute" name cure
  | Read -> (
      match Svg_table.property name with
      | Read -> kept "attribute" (name, lower (String.trim value))
      | Still | Unread _ -> None)

let of_declaration d =
  match Svg_table.property d.name with
  | Still -> None
  | Unread cure -> refuse "property" d.name cure
  | Read ->
    let css = function ("transform" | "transform-origin") as name -> "css " ^ name | name -> name in
    Option.map (fun (name, value) -> (css name, value)) (kept "property" (d.name, d.value))

let of_element element attributes =
  let style =
    match List.assoc_opt "style" attributes with
    | None -> []
    | Some text -> List.filter_map declaration (parts (without_comments text))
  in
  let important, others = List.partition (fun d -> d.important) style in
  List.filter_map (of_attribute element) attributes @ List.filter_map of_declaration (others @ important)
