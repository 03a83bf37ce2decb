type t = { path : string; text : string; first : int }

let moved n (w : Text.word) = { w with start = w.start + n }

let attribute n (a : Xml_tags.attribute) =
  { Xml_tags.key = moved n a.key; value = (n + fst a.value, n + snd a.value) }

let tags t =
  let tags = Scene.ok (Xml_tags.tags ~path:t.path t.text) in
  Scene.ok (Xml_tags.well_formed ~path:t.path t.text tags);
  let one (tag : Xml_tags.tag) =
    { tag with name = moved t.first tag.name; attributes = List.map (attribute t.first) tag.attributes }
  in
  if t.first = 0 then tags else List.map one tags

let value t a = Scene.ok (Xml_tags.value ~path:t.path t.text (attribute (-t.first) a))

let words t a =
  List.map (moved t.first) (Scene.ok (Xml_tags.words ~path:t.path t.text (attribute (-t.first) a)))
