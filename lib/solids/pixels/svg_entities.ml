open Svg_number

type t = { values : (string, string) Hashtbl.t; mutable room : int }

let most = 1_000
let empty () = { values = Hashtbl.create 16; room = 10_000_000 }

exception Other

let starts text i part =
  i + String.length part <= String.length text && String.equal (String.sub text i (String.length part)) part

let rec blanks text i = if i < String.length text && is_blank text.[i] then blanks text (i + 1) else i

let until text i test =
  let rec go k = if k >= String.length text then raise Other else if test text.[k] then k else go (k + 1) in
  go i

(* The place after a part of the text. *)
let rec after text i part =
  if i >= String.length text then raise Other
  else if starts text i part then i + String.length part
  else after text (i + 1) part

(* One declaration: a name and a value in quotes. *)
let entity t text i =
  let start = blanks text i in
  let stop = until text start is_blank in
  let name = String.sub text start (stop - start) in
  let quote = blanks text stop in
  if quote >= String.length text || not (text.[quote] = '"' || text.[quote] = '\'') then raise Other;
  let close = until text (quote + 1) (Char.equal text.[quote]) in
  let value = String.sub text (quote + 1) (close - quote - 1) in
  if String.exists (fun c -> c = '&' || c = '<' || c = '%') value || name = "%" then raise Other;
  let ended = blanks text (close + 1) in
  if not (starts text ended ">") || Hashtbl.length t.values >= most then raise Other;
  (* By XML, the first declaration holds. *)
  if not (Hashtbl.mem t.values name) then Hashtbl.replace t.values name value;
  ended + 1

let rec subset t text i =
  let i = blanks text i in
  if starts text i "]" then ()
  else if starts text i "<!--" then subset t text (after text i "-->")
  else if starts text i "<!ENTITY" then subset t text (entity t text (i + 8))
  else raise Other

(* What may come before the document type: instructions and comments. *)
let rec prolog text i =
  let i = blanks text i in
  if starts text i "<?" then prolog text (after text i "?>")
  else if starts text i "<!--" then prolog text (after text i "-->")
  else if starts text i "<!DOCTYPE" then Some i
  else None

(* A bracket outside of quotes, before the end of the tag. *)
let rec bracket text i =
  if i >= String.length text || text.[i] = '>' then None
  else if text.[i] = '[' then Some i
  else if text.[i] = '"' || text.[i] = '\'' then
    match String.index_from_opt text (i + 1) text.[i] with None -> None | Some close -> bracket text (close + 1)
  else bracket text (i + 1)

let of_text text =
  let t = empty () in
  match Option.bind (prolog text (Scc_base.Source.after_mark text)) (bracket text) with
  | None -> Some t
  | Some i -> ( match subset t text (i + 1) with () -> Some t | exception Other -> None)
  | exception Other -> Some t

let meaning t name =
  match Hashtbl.find_opt t.values name with
  | None -> None
  | Some value ->
    t.room <- t.room - String.length value - 1;
    if t.room < 0 then raise (Bad "entities that would make the drawing many times as long");
    Some value
