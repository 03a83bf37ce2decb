open Scc_base

type t = { path : string; text : string; first : int }

(* The text by itself has its places from 0 on, and so has a fault. *)
let located t = function
  | Ok found -> found
  | Error (d : Diag.t) ->
    let span = Span.make ~file:d.span.file ~start:(t.first + d.span.start) ~stop:(t.first + d.span.stop) in
    raise (Scene.Refused (if d.span.whole then d else { d with span }))

let moved n (w : Text.word) = { w with start = w.start + n }

let attribute n (a : Xml_tags.attribute) =
  { Xml_tags.key = moved n a.key; value = (n + fst a.value, n + snd a.value) }

let tags t =
  let tags = located t (Xml_tags.tags ~path:t.path t.text) in
  located t (Xml_tags.well_formed ~path:t.path t.text tags);
  let one (tag : Xml_tags.tag) =
    { tag with name = moved t.first tag.name; attributes = List.map (attribute t.first) tag.attributes }
  in
  if t.first = 0 then tags else List.map one tags

let value t a = located t (Xml_tags.value ~path:t.path t.text (attribute (-t.first) a))

let words t a =
  List.map (moved t.first) (located t (Xml_tags.words ~path:t.path t.text (attribute (-t.first) a)))
