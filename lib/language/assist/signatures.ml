open Scc_base
open Scc_syntax
open Scc_describe

type t = { forms : string list; argument : int; about : string option }

(* The opening bracket of a call around the place, with the number of commas between. *)
let call (t : Tokens.t) last =
  let rec find i commas =
    if i < 0 || (t.restart.(i) && i < last) then None
    else
      match t.tokens.(i).token with
      | (RPAREN | RBRACKET | RBRACE) when t.opening.(i) >= 0 -> find (t.opening.(i) - 1) commas
      | LPAREN when i > 0 -> Some (i, commas)
      | LPAREN | LBRACKET | LBRACE | LABEL_BRACKET -> find (i - 1) 0
      | COMMA -> find (i - 1) (commas + 1)
      | _ -> find (i - 1) commas
  in
  find last 0

let about categories name =
  List.find_map (fun c -> Vocabulary.find c name) categories
  |> Option.map (fun (e : Vocabulary.entry) -> e.meaning)

let word (t : Tokens.token) =
  match t.token with
  | OMEGA -> "omega"
  | RHO -> "rho"
  | EPS -> "eps"
  | NAME n -> n
  | _ -> ""

let forms_of (known : Known.t) source (t : Tokens.t) i =
  let spelt = word t.tokens.(i) in
  let name =
    if spelt <> "" then spelt
    else String.sub (Source.text source) t.tokens.(i).start (t.tokens.(i).stop - t.tokens.(i).start)
  in
  let is_event = i > 0 && match t.tokens.(i - 1).token with EVENT -> true | _ -> false in
  let called = if is_event then Forms.find Event name else Forms.find Called name in
  let categories =
    if is_event then [ Vocabulary.Event ] else [ Vocabulary.Function; Atom; Solid; Law; Word ]
  in
  match List.filter (fun (n, _) -> String.equal n name) known.families with
  | _ :: _ as heads -> Some (List.map snd heads, None)
  | [] -> Option.map (fun forms -> (forms, about categories name)) called

let at known text offset =
  let start, source, t = Pieces.window text offset in
  let offset = offset - start in
  let rec last i = if i >= 0 && t.tokens.(i).stop > offset then last (i - 1) else i in
  let before = last (Array.length t.tokens - 2) in
  (* brackets that call nothing are within a call *)
  let rec innermost i =
    match call t i with
    | None -> None
    | Some (opening, commas) -> (
        match forms_of known source t (opening - 1) with
        | Some (forms, about) -> Some { forms; argument = commas; about }
        | None -> innermost (opening - 1))
  in
  innermost before

let arguments form =
  match String.index_opt form '(' with
  | None -> []
  | Some opening ->
    let stop = Option.value (String.rindex_opt form ')') ~default:(String.length form) in
    let rec split i from depth found =
      if i >= stop then if stop > from then (from, stop) :: found else found
      else
        match form.[i] with
        | '(' | '{' | '<' -> split (i + 1) from (depth + 1) found
        | ')' | '}' | '>' -> split (i + 1) from (depth - 1) found
        | ',' when depth = 0 ->
          let next = if i + 1 < stop && form.[i + 1] = ' ' then i + 2 else i + 1 in
          split (i + 1) next depth ((from, i) :: found)
        | _ -> split (i + 1) from depth found
    in
    List.rev (split (opening + 1) (opening + 1) 0 [])
