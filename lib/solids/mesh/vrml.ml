open Scc_base
open Text

(* Tokens: braces and brackets by themselves; comments and strings left out. *)
let tokens text =
  let n = String.length text in
  let is_blank c = c = ' ' || c = '\t' || c = '\n' || c = '\r' || c = ',' || c = '\x0c' in
  let is_bracket c = c = '{' || c = '}' || c = '[' || c = ']' in
  let rec to_line_end i = if i < n && text.[i] <> '\n' && text.[i] <> '\r' then to_line_end (i + 1) else i in
  let rec after_quote i =
    if i >= n then n
    else
      match text.[i] with
      | '"' -> i + 1
      | '\\' -> after_quote (i + 2)
      | _ -> after_quote (i + 1)
  in
  let rec word_end i =
    let parts c = is_blank c || is_bracket c || c = '#' || c = '"' in
    if i < n && not (parts text.[i]) then word_end (i + 1) else i
  in
  let rec scan acc i =
    if i >= n then List.rev acc
    else
      match text.[i] with
      | '#' -> scan acc (to_line_end i)
      | '"' -> scan acc (after_quote (i + 1))
      | c when is_blank c -> scan acc (i + 1)
      | c when is_bracket c -> scan ({ text = String.make 1 c; start = i } :: acc) (i + 1)
      | _ ->
        let stop = word_end i in
        scan ({ text = String.sub text i (stop - i); start = i } :: acc) stop
  in
  scan [] 0

(* The words up to the closing bracket. *)
let rec bracketed ~path at acc = function
  | { text = "]"; _ } :: rest -> Ok (List.rev acc, rest)
  | { text = "{" | "}" | "["; _ } as w :: _ ->
    error ~path w "expected a number or `]`, found %s" (quote w.text)
  | w :: rest -> bracketed ~path at (w :: acc) rest
  | [] -> error ~path at "a `[` without its `]`"

(* [nodes] are the names of the open nodes, the innermost first; [sets] in reverse order. *)
type state = {
  nodes : string list;
  sets : Face_sets.t list;
  def : string option;  (* of the node that comes next *)
  shape : string option;  (* what the present shape is called *)
}

let in_node state name =
  match state.nodes with
  | n :: _ -> String.equal n name
  | [] -> false

let in_face_set state = List.exists (String.equal "IndexedFaceSet") state.nodes

let update state f =
  match state.sets with
  | set :: rest -> { state with sets = f set :: rest }
  | [] -> state

let open_node state (w : word) =
  let def = state.def in
  let state = { state with nodes = w.text :: state.nodes; def = None } in
  match w.text with
  | "IndexedFaceSet" ->
    let name = if Option.is_some def then def else state.shape in
    { state with sets = { points = []; index = []; ccw = true; name } :: state.sets }
  | "Shape" -> { state with shape = def }
  | _ -> state

let rec take n acc = function
  | w :: rest when n > 0 -> take (n - 1) (w :: acc) rest
  | rest -> (List.rev acc, rest)

(* A field of a Transform, which must be the identity. *)
let transform_field ~path (w : word) rest =
  let length =
    match w.text with
    | "rotation" | "scaleOrientation" -> 4
    | _ -> 3
  in
  let values, rest = take length [] rest in
  let* moves = Face_sets.moves ~path w.text values in
  if moves then error ~path w "`%s` of a Transform is not supported: apply it to the points first" w.text
  else Ok rest

let rec scan ~path state tokens =
  let in_node = in_node state in
  let go_on rest change =
    let* value, rest = rest in
    scan ~path (change value) rest
  in
  match tokens with
  | [] -> Ok (List.rev state.sets)
  | ({ text = "translation" | "rotation" | "scale" | "center"; _ } as w) :: rest when in_node "Transform" ->
    let* rest = transform_field ~path w rest in
    scan ~path state rest
  | { text = "DEF"; _ } :: name :: rest -> scan ~path { state with def = Some name.text } rest
  | ({ text = "USE" | "PROTO" | "EXTERNPROTO" | "Inline"; _ } as w) :: _ ->
    error ~path w "`%s` is not supported" w.text
  | ({ text = "}"; _ } as w) :: rest -> (
      match state.nodes with
      | _ :: nodes -> scan ~path { state with nodes } rest
      | [] -> error ~path w "a `}` without its `{`")
  | { text = "point"; _ } :: ({ text = "["; _ } as at) :: rest
    when in_node "Coordinate" && in_face_set state ->
    go_on (bracketed ~path at [] rest) (fun points ->
        update state (fun set -> { set with points }))
  | { text = "coordIndex"; _ } :: ({ text = "["; _ } as at) :: rest when in_node "IndexedFaceSet" ->
    go_on (bracketed ~path at [] rest) (fun index ->
        update state (fun set -> { set with index }))
  | { text = "ccw"; _ } :: { text = ("TRUE" | "FALSE") as value; _ } :: rest when in_node "IndexedFaceSet" ->
    let ccw = String.equal value "TRUE" in
    scan ~path (update state (fun set -> { set with ccw })) rest
  | w :: { text = "{"; _ } :: rest -> scan ~path (open_node state w) rest
  | ({ text = "{"; _ } as w) :: rest -> scan ~path (open_node state { w with text = "" }) rest
  | _ :: rest -> scan ~path state rest

let is_vrml_1 text =
  let mark = "#VRML V1" in
  let head = String.trim (String.sub text 0 (min 80 (String.length text))) in
  String.length head >= String.length mark && String.equal (String.sub head 0 (String.length mark)) mark

let read ~path text =
  if is_vrml_1 text then
    Error
      (Diag.error Code.mesh_format
         (Span.of_file path)
         "VRML 1 files are not supported" ~hint:"convert the file to VRML 2 (VRML97), X3D, PLY or OFF")
  else
    let* sets = scan ~path { nodes = []; sets = []; def = None; shape = None } (tokens text) in
    Face_sets.to_ifs ~path sets
