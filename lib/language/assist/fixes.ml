open Scc_base
open Scc_syntax
open Scc_describe

type t = { title : string; edits : Rename.edit list }

let slice (r : Reading.t) (at : Span.t) =
  let text = Source.text r.source in
  let stop = Int.min at.stop (String.length text) in
  if at.start > stop then "" else String.sub text at.start (stop - at.start)

let place (at : Span.t) start stop = Span.make ~file:at.file ~start ~stop
let is (code : Code.t) (d : Diag.t) = String.equal d.code (code :> string)

(* {1 A name that is spelt wrongly} *)

(* What stands between the marks ` of a message. *)
let quoted message = List.filteri (fun i _ -> i mod 2 = 1) (String.split_on_char '`' message)

let find_word text word =
  let n = String.length text and m = String.length word in
  let part c = match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | c -> Char.code c >= 128 in
  let alone i = (i = 0 || not (part text.[i - 1])) && (i + m = n || not (part text.[i + m])) in
  let rec find i =
    if m = 0 || i + m > n then None
    else if String.equal (String.sub text i m) word && alone i then Some i
    else find (i + 1)
  in
  find 0

(* Without indices and arguments: they stay as they are written. *)
let bare name =
  let rec stop i = if i < String.length name && name.[i] <> '[' && name.[i] <> '(' then stop (i + 1) else i in
  String.sub name 0 (stop 0)

(* Without the import `m` of `m.Cube`. *)
let unqualified name =
  match String.index_opt name '.' with
  | Some i -> Some (String.sub name 0 (i + 1), String.sub name (i + 1) (String.length name - i - 1))
  | None -> None

(* Where the wrong name stands in the place, which may be a whole path, and what is put there. The place of `m.Cub`
   may be that of `Cub` alone. *)
let places (r : Reading.t) (d : Diag.t) name =
  let text = slice r d.span in
  let within word put = Option.map (fun i -> (i, i + String.length word, put)) (find_word text word) in
  let without_import m wrong =
    let start = d.span.start - String.length m in
    let written = start >= 0 && String.equal (String.sub (Source.text r.source) start (String.length m)) m in
    if written && String.equal text wrong then Some (-String.length m, String.length wrong, name) else None
  in
  let of_word word =
    match (within word name, unqualified word, unqualified name) with
    | (Some _ as found), _, _ -> found
    | None, Some (m, wrong), Some (m', right) when String.equal m m' -> within wrong right
    | None, Some (m, wrong), None -> without_import m wrong
    | None, _, _ -> None
  in
  let plain = text <> "" && not (String.exists (fun c -> String.contains " .[](){}<>," c) text) in
  match List.find_map of_word (List.map bare (quoted d.message)) with
  | Some _ as found -> found
  | None -> if plain && not (String.equal text name) then Some (0, String.length text, name) else None

let misspelt r (d : Diag.t) =
  let change (start, stop, put) =
    let at = place d.span (d.span.start + start) (d.span.start + stop) in
    { title = Printf.sprintf "replace by `%s`" put; edits = [ (at, put) ] }
  in
  let fix name = Option.map change (places r d name) in
  List.filter_map fix (Option.fold ~none:[] ~some:Diag.suggestions d.hint)

(* {1 Syntax} *)

let token_before (r : Reading.t) offset =
  let before (t : Tokens.token) = t.stop <= offset && t.stop > t.start in
  Array.fold_left (fun found t -> if before t then Some t else found) None (Lazy.force r.tokens).tokens

let product (d : Diag.t) =
  match d.hint with
  | Some hint when is Code.syntax d && String.equal hint Parse.product_hint ->
    [ { title = "insert `*`"; edits = [ (place d.span d.span.start d.span.start, "*") ] } ]
  | _ -> []

(* `A F` for `AF`. *)
let one_word r (d : Diag.t) =
  match (d.hint, token_before r d.span.start) with
  | Some hint, Some before when is Code.syntax d -> (
      match Parse.joined_hint hint with
      | Some word ->
        [ { title = Printf.sprintf "write `%s`" word; edits = [ (place d.span before.start d.span.stop, word) ] } ]
      | None -> [])
  | _ -> []

(* {1 What is not needed} *)

let rec item_at offset (items : Ast.model) =
  let within (i : Ast.item) = i.at.start <= offset && offset < i.at.stop in
  match List.find_opt within items with
  | Some { it = For (_, inner); _ } -> item_at offset inner
  | found -> found

(* The lines of a declaration, where nothing else stands on them. *)
let lines_of text (at : Span.t) =
  let rec back i = if i > 0 && (text.[i - 1] = ' ' || text.[i - 1] = '\t') then back (i - 1) else i in
  let n = String.length text in
  let rec forth i = if i < n && (text.[i] = ' ' || text.[i] = '\t' || text.[i] = '\r') then forth (i + 1) else i in
  let start = back at.start and stop = forth at.stop in
  let begins = start = 0 || text.[start - 1] = '\n' in
  if begins && stop < n && text.[stop] = '\n' then (start, stop + 1)
  else if begins && stop = n then (start, n)
  else (at.start, at.stop)

let unused (r : Reading.t) (d : Diag.t) =
  if not (is Code.unused d) then []
  else
    match item_at d.span.start (Lazy.force r.model) with
    | None -> []
    | Some i ->
      let start, stop = lines_of (Source.text r.source) i.at in
      [ { title = Printf.sprintf "remove `%s`" (slice r d.span); edits = [ (place d.span start stop, "") ] } ]

let unseen (d : Diag.t) =
  if is Code.direction d && d.span.stop > d.span.start then
    [ { title = "remove what is not to be seen"; edits = [ (d.span, "") ] } ]
  else []

let of_diagnostic r (d : Diag.t) =
  if not (String.equal d.span.file (Source.name r.Reading.source)) then []
  else misspelt r d @ product d @ one_word r d @ unused r d @ unseen d

let same_edit (((a : Span.t), put) : Rename.edit) (((b : Span.t), put') : Rename.edit) =
  Span.equal a b && String.equal put put'

let of_diagnostics r found =
  let add all (d, f) =
    if List.exists (fun (_, g) -> List.equal same_edit f.edits g.edits) all then all else (d, f) :: all
  in
  let all d = List.map (fun f -> (d, f)) (of_diagnostic r d) in
  List.rev (List.fold_left add [] (List.concat_map all found))
