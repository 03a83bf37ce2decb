open Scc_base
open Text

(* Tokens: braces and brackets by themselves, strings with the quote before them; comments left out. *)
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
      | '"' ->
        let stop = after_quote (i + 1) in
        scan ({ text = String.sub text i (min n stop - i); start = i } :: acc) stop
      | c when is_blank c -> scan acc (i + 1)
      | c when is_bracket c -> scan ({ text = String.make 1 c; start = i } :: acc) (i + 1)
      | _ ->
        let stop = word_end i in
        scan ({ text = String.sub text i (stop - i); start = i } :: acc) stop
  in
  scan [] 0

(* Nodes are built from the tokens that are left. *)
type reader = { path : string; mutable left : word list; names : Scene.names; mutable routes : Scene.route list }

(* {1 Words} *)

let is_bracket w = match w.text with "{" | "}" | "[" | "]" -> true | _ -> false

(* A number, a string or a truth value, and no name. *)
let is_plain w =
  match w.text.[0] with
  | '0' .. '9' | '+' | '-' | '.' | '"' -> true
  | _ -> String.equal w.text "TRUE" || String.equal w.text "FALSE"

let is_name w = not (is_plain w || is_bracket w)

let rec plain r found =
  match r.left with
  | w :: rest when is_plain w ->
    r.left <- rest;
    plain r (w :: found)
  | _ -> List.rev found

(* A bracket, with all that is in it. *)
let skip_brackets r =
  let rec go at depth =
    match r.left with
    | [] -> Scene.bad ~path:r.path at "a `%s` without its end" at.text
    | w :: rest ->
      r.left <- rest;
      let depth = match w.text with "{" | "[" -> depth + 1 | "}" | "]" -> depth - 1 | _ -> depth in
      if depth > 0 then go at depth
  in
  match r.left with
  | ({ text = "[" | "{"; _ } as at) :: _ -> go at 0
  | w :: _ -> Scene.bad ~path:r.path w "expected a bracket, found %s" (quote w.text)
  | [] -> Scene.ok (error_at ~path:r.path 0 "the file ends where a bracket is expected")

(* {1 Statements that are no nodes} *)

let route r (at : word) (target : word) =
  match String.split_on_char '.' target.text with
  | [ node; field ] -> r.routes <- { Scene.at; node; field } :: r.routes
  | _ -> Scene.bad ~path:r.path target "expected a node and its field, found %s" (quote target.text)

(* [false] if there is none. *)
let statement r =
  let after rest f =
    r.left <- rest;
    f ();
    true
  in
  match r.left with
  | ({ text = "ROUTE"; _ } as at) :: _ :: { text = "TO"; _ } :: target :: rest ->
    after rest (fun () -> route r at target)
  | { text = "PROTO"; _ } :: _ :: rest ->
    after rest (fun () ->
        skip_brackets r;
        skip_brackets r)
  | { text = "EXTERNPROTO"; _ } :: _ :: rest ->
    after rest (fun () ->
        skip_brackets r;
        match r.left with { text = "["; _ } :: _ -> skip_brackets r | _ -> ignore (plain r []))
  | { text = "PROFILE" | "COMPONENT"; _ } :: _ :: rest | { text = "META"; _ } :: rest ->
    after rest (fun () -> ignore (plain r []))
  | ({ text = "UNIT"; _ } as at) :: { text = category; _ } :: _ :: factor :: rest ->
    after rest (fun () -> Scene_unit.check ~path:r.path at ~category ~factor)
  | { text = "EXPORT"; _ } :: _ :: { text = "AS"; _ } :: _ :: rest | { text = "EXPORT"; _ } :: _ :: rest ->
    after rest ignore
  | _ -> false

(* {1 Nodes} *)

let starts_node r =
  match r.left with
  | { text = "DEF" | "USE"; _ } :: w :: _ -> is_name w
  | kind :: { text = "{"; _ } :: _ -> is_name kind
  | _ -> false

let rec node r depth =
  if depth > Scene.max_depth then
    Scene.bad ~path:r.path (List.hd r.left) "nodes are inside of each other more than %d deep" Scene.max_depth;
  match r.left with
  | { text = "USE"; _ } :: name :: rest ->
    r.left <- rest;
    Scene.used ~path:r.path r.names name
  | { text = "DEF"; _ } :: name :: kind :: ({ text = "{"; _ } as at) :: rest when is_name kind ->
    r.left <- rest;
    body r depth at kind (Some name.text)
  | kind :: ({ text = "{"; _ } as at) :: rest when is_name kind ->
    r.left <- rest;
    body r depth at kind None
  | w :: _ -> Scene.bad ~path:r.path w "expected a node, found %s" (quote w.text)
  | [] -> Scene.ok (error_at ~path:r.path 0 "the file ends where a node is expected")

and body r depth at kind name =
  Scene.opening r.names name;
  let rec go fields =
    if statement r then go fields
    else
      match r.left with
      | { text = "}"; _ } :: rest ->
        r.left <- rest;
        List.rev fields
      | w :: rest when is_name w ->
        r.left <- rest;
        go ((w, value r depth) :: fields)
      | w :: _ -> Scene.bad ~path:r.path w "expected a field of %s or `}`, found %s" kind.text (quote w.text)
      | [] -> Scene.bad ~path:r.path at "a `{` without its `}`"
  in
  let node = { Scene.kind; name; fields = go [] } in
  Scene.closing r.names node;
  node

and value r depth =
  match r.left with
  | ({ text = "["; _ } as at) :: rest ->
    r.left <- rest;
    list r depth at
  | { text = "NULL"; _ } :: rest ->
    r.left <- rest;
    Scene.Nodes []
  | _ when starts_node r -> Nodes [ node r (depth + 1) ]
  | _ -> Words (plain r [])

and list r depth at =
  let rec nodes found =
    if statement r then nodes found
    else
      match r.left with
      | { text = "]"; _ } :: rest ->
        r.left <- rest;
        List.rev found
      | [] -> Scene.bad ~path:r.path at "a `[` without its `]`"
      | _ -> nodes (node r (depth + 1) :: found)
  in
  if starts_node r then Scene.Nodes (nodes [])
  else
    let words = plain r [] in
    match r.left with
    | { text = "]"; _ } :: rest ->
      r.left <- rest;
      Words words
    | w :: _ -> Scene.bad ~path:r.path w "expected a number or `]`, found %s" (quote w.text)
    | [] -> Scene.bad ~path:r.path at "a `[` without its `]`"

let scene ~path text =
  let r = { path; left = tokens text; names = Scene.names (); routes = [] } in
  let rec go found =
    if statement r then go found
    else
      match r.left with
      | [] -> List.rev found
      | { text = "IMPORT"; _ } as w :: _ ->
        Scene.unread ~path w ~hint:(Scene_table.cure w.text) "`IMPORT` is not read"
      | { text = "}" | "]"; _ } as w :: _ -> Scene.bad ~path w "a `%s` without its start" w.text
      | _ -> go (node r 0 :: found)
  in
  let nodes = go [] in
  { Scene.nodes; routes = List.rev r.routes; names = Scene.known r.names }

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
  else Scene_solid.read ~path ~size:(String.length text) (fun () -> scene ~path text)
