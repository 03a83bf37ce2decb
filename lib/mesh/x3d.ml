open Text

type tag = { name : word; attributes : (string * (int * int)) list  (* the places of the values *) }

let is_space c = c = ' ' || c = '\t' || c = '\n' || c = '\r'
let is_name c = not (is_space c || c = '>' || c = '/' || c = '=' || c = '<')

let rec skip text test i = if i < String.length text && test text.[i] then skip text test (i + 1) else i

let find text part from =
  let n = String.length part in
  let rec go i =
    if i + n > String.length text then None
    else if String.equal (String.sub text i n) part then Some i
    else go (i + 1)
  in
  go from

(* The attributes from [i] to the end of the tag, and the position after it. *)
let rec attributes ~path name text acc i =
  let i = skip text is_space i in
  if i >= String.length text then error ~path name "the tag %s does not end" (quote name.text)
  else if text.[i] = '>' then Ok (acc, i + 1)
  else if not (is_name text.[i]) then attributes ~path name text acc (i + 1)
  else
    let stop = skip text is_name i in
    let equals = skip text is_space stop in
    let quote_at = skip text is_space (equals + 1) in
    let quoted =
      equals < String.length text && text.[equals] = '=' && quote_at < String.length text
      && (text.[quote_at] = '"' || text.[quote_at] = '\'')
    in
    match if quoted then String.index_from_opt text (quote_at + 1) text.[quote_at] else None with
    | Some close ->
      let attribute = (String.sub text i (stop - i), (quote_at + 1, close)) in
      attributes ~path name text (attribute :: acc) (close + 1)
    | None -> error_at ~path i "expected an attribute with a quoted value"

(* Tags in order, closing ones with a leading slash in their names; comments and declarations left out. *)
let tags ~path text =
  let rec go acc i =
    match String.index_from_opt text i '<' with
    | None -> Ok (List.rev acc)
    | Some i -> (
        let after what close =
          match find text close (i + 1) with
          | Some j -> go acc (j + String.length close)
          | None -> error_at ~path i "%s does not end" what
        in
        let starts part =
          i + String.length part <= String.length text
          && String.equal (String.sub text i (String.length part)) part
        in
        if starts "<!--" then after "a comment" "-->"
        else if starts "<![CDATA[" then after "a CDATA section" "]]>"
        else if starts "<!" then after "a declaration" ">"
        else if starts "<?" then after "an instruction" "?>"
        else
          let start = if starts "</" then i + 2 else i + 1 in
          let stop = skip text is_name start in
          let name = { text = String.sub text (i + 1) (stop - i - 1); start = i + 1 } in
          match attributes ~path name text [] stop with
          | Ok (attributes, next) -> go ({ name; attributes } :: acc) (min next (String.length text))
          | Error _ as e -> e)
  in
  go [] 0

let value text tag key =
  Option.map
    (fun (start, stop) -> (start, stop, String.sub text start (stop - start)))
    (List.assoc_opt key tag.attributes)

let words_of text tag key =
  match value text tag key with
  | Some (start, stop, _) -> Face_sets.words text start stop
  | None -> []

let fields = [ "translation"; "rotation"; "scale"; "center" ]

let check ~path text tag =
  let has key = List.mem_assoc key tag.attributes in
  match tag.name.text with
  | "Transform" ->
    let moves key = Face_sets.moves ~path key (words_of text tag key) in
    let* moving = map moves (List.filter has fields) in
    if List.exists Fun.id moving then
      error ~path tag.name "a Transform that moves points is not supported: apply it to the points first"
    else Ok ()
  | "ProtoInstance" | "Inline" -> error ~path tag.name "`%s` is not supported" tag.name.text
  | ("IndexedFaceSet" | "Coordinate") when has "USE" -> error ~path tag.name "`USE` is not supported"
  | _ -> Ok ()

let add text (inside, sets) tag =
  match (tag.name.text, sets) with
  | "IndexedFaceSet", _ ->
    let ccw =
      match value text tag "ccw" with
      | Some (_, _, ("false" | "FALSE")) -> false
      | Some _ | None -> true
    in
    (true, { Face_sets.points = []; index = words_of text tag "coordIndex"; ccw; at = tag.name } :: sets)
  | "/IndexedFaceSet", _ -> (false, sets)
  | "Coordinate", set :: rest when inside ->
    (inside, { set with Face_sets.points = words_of text tag "point" } :: rest)
  | _ -> (inside, sets)

let read ~path text =
  let* tags = tags ~path text in
  let* _ = map (check ~path text) tags in
  let _, sets = List.fold_left (add text) (false, []) tags in
  Face_sets.to_ifs ~path (List.rev sets)
