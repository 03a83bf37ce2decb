type t = { path : string; text : string; first : int }

let moved n (w : Text.word) = { w with start = w.start + n }

let moved_attribute n (a : Xml_tags.attribute) =
  { Xml_tags.key = moved n a.key; value = (n + fst a.value, n + snd a.value) }

let tags t =
  let tags = Scene.ok (Xml_tags.tags ~path:t.path t.text) in
  Scene.ok (Xml_tags.well_formed ~path:t.path t.text tags);
  let one (tag : Xml_tags.tag) =
    { tag with name = moved t.first tag.name; attributes = List.map (moved_attribute t.first) tag.attributes }
  in
  if t.first = 0 then tags else List.map one tags

let value t a = Scene.ok (Xml_tags.value ~path:t.path t.text (moved_attribute (-t.first) a))

let words t a =
  List.map (moved t.first) (Scene.ok (Xml_tags.words ~path:t.path t.text (moved_attribute (-t.first) a)))

(* {1 Attributes} *)

let attribute (tag : Xml_tags.tag) key =
  List.find_opt (fun (a : Xml_tags.attribute) -> String.equal a.key.text key) tag.attributes

let value_of t tag key = Option.map (value t) (attribute tag key)

let needed t (tag : Xml_tags.tag) key =
  match value_of t tag key with
  | Some value -> value
  | None -> Scene.bad ~path:t.path tag.name "`%s` of %s is missing" key tag.name.text

let needed_word t (tag : Xml_tags.tag) key =
  let text = needed t tag key in
  { Text.text; start = (match attribute tag key with Some a -> fst a.value | None -> tag.name.start) }

(* {1 Interfaces} *)

let declared t tag =
  let access =
    match value_of t tag "accessType" with
    | Some "inputOnly" -> Scene.In
    | Some "outputOnly" -> Out
    | Some "initializeOnly" -> Field
    | Some "inputOutput" -> Exposed
    | None -> Unsaid
    | Some other ->
      Scene.bad ~path:t.path (needed_word t tag "accessType")
        "%s is no access of a field: inputOnly, outputOnly, initializeOnly or inputOutput" (Text.quote other)
  in
  let type_ = Option.value (value_of t tag "type") ~default:"" in
  if Option.is_some (attribute tag "type") then Scene_type.check ~path:t.path (needed_word t tag "type");
  { Scene.field = needed_word t tag "name"; type_; access }

(* Where a value of a field stands. *)
let place_of_value (tag : Xml_tags.tag) inside =
  match (attribute tag "value", inside) with
  | Some a, _ -> Some a.key
  | None, (first : Xml_tags.tag) :: _ -> Some first.name
  | None, [] -> None

let outer_field t (tag, inside) =
  match place_of_value tag inside with
  | Some place ->
    Scene.bad ~path:t.path place "a field of an ExternProtoDeclare has no value: the other file gives it one"
  | None -> declared t tag

let inner_field t (tag, inside) =
  let own = declared t tag in
  let event = match own.access with In | Out -> true | Field | Exposed | Unsaid -> false in
  match place_of_value tag inside with
  | Some place when event -> Scene.bad ~path:t.path place "an event has no value"
  | Some _ | None -> (own, event)
