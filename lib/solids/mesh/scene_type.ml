type one = Truth | Integer | Number | Text | Image | Node

(* What one value is made of, and how many of them. *)
let kinds =
  [
    ("Bool", Truth, 1); ("Int32", Integer, 1); ("Float", Number, 1); ("Double", Number, 1); ("Time", Number, 1);
    ("Vec2f", Number, 2); ("Vec3f", Number, 3); ("Vec4f", Number, 4); ("Vec2d", Number, 2); ("Vec3d", Number, 3);
    ("Vec4d", Number, 4); ("Rotation", Number, 4); ("Color", Number, 3); ("ColorRGBA", Number, 4);
    ("Matrix3f", Number, 9); ("Matrix4f", Number, 16); ("Matrix3d", Number, 9); ("Matrix4d", Number, 16);
    ("Image", Image, 3); ("String", Text, 1); ("Node", Node, 1);
  ]

let find type_ =
  if String.length type_ < 3 then None
  else
    let name = String.sub type_ 2 (String.length type_ - 2) in
    let kind = List.find_opt (fun (other, _, _) -> String.equal other name) kinds in
    match (String.sub type_ 0 2, kind) with
    | "SF", Some (_, one, n) -> Some (false, one, n)
    | "MF", Some (_, one, n) -> Some (true, one, n)
    | _ -> None

let check ~path (w : Text.word) =
  if Option.is_none (find w.text) then
    let lower = String.lowercase_ascii w.text in
    let names = List.concat_map (fun (name, _, _) -> [ "SF" ^ name; "MF" ^ name ]) kinds in
    match List.find_opt (fun name -> String.equal (String.lowercase_ascii name) lower) names with
    | Some name -> Scene.bad ~path w "%s is no type of a field; %s is one" (Text.quote w.text) name
    | None -> Scene.bad ~path w "%s is no type of a field, such as SFVec3f or MFNode" (Text.quote w.text)

(* {1 Values} *)

let is_number text =
  String.for_all (function '0' .. '9' | '+' | '-' | '.' | 'e' | 'E' -> true | _ -> false) text
  && Option.is_some (float_of_string_opt text)

let is_integer text =
  let body = match text.[0] with '+' | '-' -> String.sub text 1 (String.length text - 1) | _ -> text in
  let all test s = s <> "" && String.for_all test s in
  let digit c = c >= '0' && c <= '9' in
  let hexadecimal c = digit c || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F') in
  all digit body
  || String.length body > 2
     && (String.starts_with ~prefix:"0x" body || String.starts_with ~prefix:"0X" body)
     && all hexadecimal (String.sub body 2 (String.length body - 2))

let fits ~quoted one text =
  text <> ""
  &&
  match one with
  | Truth -> List.mem text [ "TRUE"; "FALSE"; "true"; "false" ]
  | Integer | Image -> is_integer text
  | Number -> is_number text
  | Text -> (not quoted) || text.[0] = '"'
  | Node -> false

let what = function
  | Truth -> "TRUE or FALSE"
  | Integer | Image -> "an integer"
  | Number -> "a number"
  | Text -> "a string"
  | Node -> "a node"

let check_value ~path ~quoted (at : Text.word) ~type_ value =
  match (find type_, value) with
  | None, _ -> ()
  | Some (many, Node, _), Scene.Nodes nodes ->
    if (not many) && List.compare_length_with nodes 1 > 0 then
      Scene.bad ~path at "%s is of the type %s, and has more than one node" (Text.quote at.text) type_
  | Some (_, _, _), Nodes [] -> Scene.bad ~path at "%s is of the type %s, and has none" (Text.quote at.text) type_
  | Some (_, _, _), Nodes (node :: _) ->
    Scene.bad ~path node.kind "%s is of the type %s, and here is a node" (Text.quote at.text) type_
  | Some (true, _, _), Words [] | Some (false, Node, _), Words [] -> ()
  | Some (many, one, n), Words words -> (
      let fine (w : Text.word) = fits ~quoted one w.text in
      match List.find_opt (fun w -> not (fine w)) words with
      | Some w when one <> Text || quoted ->
        Scene.bad ~path w "%s is of the type %s: expected %s, found %s" (Text.quote at.text) type_ (what one)
          (Text.quote w.text)
      | _ ->
        let count = List.length words in
        let right =
          match (one, many) with
          | Text, _ when not quoted -> true
          | Image, _ -> count >= n
          | _, true -> count mod n = 0
          | _, false -> count = n
        in
        if not right then
          Scene.bad ~path at "%s is of the type %s: expected %s%s, found %d" (Text.quote at.text) type_
            (if many then "groups of " else if one = Image then "at least " else "")
            (Scc_base.Plural.count n "word" "words") count)

let check_values ~path ~quoted interface values =
  let one ((w : Text.word), value) =
    check_value ~path ~quoted w ~type_:(Scene.type_of interface w.text) value
  in
  List.iter one values

(* {1 Connections} *)

let of_field ~kind field =
  match (kind, field) with
  | "Extrusion", "scale" -> "MFVec2f"
  | "ElevationGrid", "height" -> "MFFloat"
  | "CoordinateDouble", "point" -> "MFVec3d"
  | _ -> (
      let read = match Scene_table.find kind with Read { read; _ } -> List.mem field read | _ -> false in
      if not read then ""
      else
        match field with
        | "children" | "choice" | "level" -> "MFNode"
        | "shape" | "geometry" | "coord" -> "SFNode"
        | "visible" | "load" | "ccw" | "bottom" | "side" | "top" | "beginCap" | "endCap" -> "SFBool"
        | "translation" | "scale" | "center" | "size" -> "SFVec3f"
        | "rotation" | "scaleOrientation" -> "SFRotation"
        | "whichChoice" | "xDimension" | "zDimension" -> "SFInt32"
        | "xSpacing" | "zSpacing" | "height" | "radius" | "bottomRadius" -> "SFFloat"
        | "coordIndex" | "stripCount" | "fanCount" | "index" -> "MFInt32"
        | "url" -> "MFString"
        | "crossSection" -> "MFVec2f"
        | "spine" | "point" -> "MFVec3f"
        | "orientation" -> "MFRotation"
        | _ -> "")

(* Numbers are read alike in single and in double precision. *)
let precision type_ =
  match type_ with
  | "SFDouble" -> "SFFloat"
  | "MFDouble" -> "MFFloat"
  | _ when type_ <> "" && type_.[String.length type_ - 1] = 'd' && Option.is_some (find type_) ->
    String.sub type_ 0 (String.length type_ - 1) ^ "f"
  | _ -> type_

let check_connected ~path (w : Text.word) ~inner (own : Text.word) ~outer =
  if inner <> "" && outer <> "" && not (String.equal (precision inner) (precision outer)) then
    Scene.bad ~path own "%s is of the type %s, and %s of the prototype is of the type %s" (Text.quote w.text) inner
      (Text.quote own.text) outer

let check_event ~path ~(kind : Text.word) (w : Text.word) (own : Text.word) =
  let event prefix suffix =
    let n = String.length w.text - String.length prefix - String.length suffix in
    if n > 0 && String.starts_with ~prefix w.text && String.ends_with ~suffix w.text then
      let field = String.sub w.text (String.length prefix) n in
      if of_field ~kind:kind.text field <> "" then
        Scene.bad ~path w "%s is an event, and %s has a value: connect the field %s with it" (Text.quote w.text)
          (Text.quote own.text) (Text.quote field)
  in
  event "set_" "";
  event "" "_changed"

let no_prototype ~path (w : Text.word) =
  Scene.bad ~path w "`IS` connects a field of a node to one of the prototype around it, and here is no prototype"

let connected ~path is declared prototypes ~(kind : Text.word) (w : Text.word) (own : Text.word) =
  match declared with
  | None -> no_prototype ~path is
  | Some (interface, fields) ->
    let value = Scene.connected ~path fields own in
    let inner =
      match List.assoc_opt kind.text prototypes with
      | Some (Scene.Own { interface; _ } | Elsewhere { interface; _ }) -> Scene.type_of interface w.text
      | Some Inside | None -> of_field ~kind:kind.text w.text
    in
    if Option.is_some value then check_event ~path ~kind w own;
    check_connected ~path w ~inner own ~outer:(Scene.type_of interface own.text);
    value
