open Scc_base
open Scc_syntax
open Scc_describe

type t = { words : string array; count : int; items : item list }
and item = { word : string; name : string; first : int; stop : int }

let is_name w =
  String.length w > 0 && match w.[0] with 'a' .. 'z' | 'A' .. 'Z' -> true | c -> Char.code c >= 128

let begins = function
  | "behaviour" | "binding" | "bond" | "bonds" | "check" | "collisions" | "compound" | "dynamics" | "fixed" | "for"
  | "import" | "let" | "model" | "motion" | "param" | "process" | "resolution" | "shape" | "split_step"
  | "timestep" | "network" | "blocked" -> true
  | _ -> false

(* `bonds(rope)`, `<bond, …>` and `{bond, …}` begin nothing, nor does a loop within a choice. What stands in a loop
   begins after its bracket. *)
let begins_at words i =
  let next = if i + 1 < Array.length words then words.(i + 1) else "" in
  let before = if i > 0 then words.(i - 1) else "" in
  begins words.(i)
  && (not (List.mem before [ "<"; "~"; ","; "("; "." ]))
  && (not (String.equal before "{") || is_name next || String.equal next "<")
  && (match words.(i) with
      | "bond" -> String.equal next "<"
      | "for" -> is_name next && not (List.mem before [ "choose"; "," ])
      | _ -> next = "" || is_name next || List.mem next [ "<" ] || (next.[0] >= '0' && next.[0] <= '9'))

let items words =
  let n = Array.length words in
  let name i = if i + 1 < n && is_name words.(i + 1) then words.(i + 1) else "" in
  let rec collect i stop found =
    if i < 0 then found
    else if begins_at words i then
      collect (i - 1) i ({ word = words.(i); name = name i; first = i; stop } :: found)
    else collect (i - 1) stop found
  in
  collect (n - 1) n []

let spelt source (t : Tokens.token) =
  match t.token with
  | OMEGA -> "omega"
  | RHO -> "rho"
  | EPS -> "eps"
  | LT -> "<"
  | GT -> ">"
  | TILDE -> "~"
  | DOT -> "."
  | BARRED n | NAME n -> n
  | _ -> String.sub (Source.text source) t.start (t.stop - t.start)

(* {1 The window}

   Only the declaration at the place is looked at, so that the answer takes as long in a long text as in a short
   one. *)

let widest = 100_000

let starts_declaration text from =
  let n = String.length text in
  let rec blank i = if i < n && (text.[i] = ' ' || text.[i] = '\t') then blank (i + 1) else i in
  let start = blank from in
  let rec word i = if i < n && (text.[i] = '_' || (text.[i] >= 'a' && text.[i] <= 'z')) then word (i + 1) else i in
  let stop = word start in
  stop > start && begins (String.sub text start (stop - start))

let line_start text i =
  if i <= 0 then 0 else match String.rindex_from_opt text (i - 1) '\n' with Some k -> k + 1 | None -> 0


(* Two declarations back: the word at hand may look as if it began one. *)
let window_start text offset =
  let rec back i wanted =
    if i = 0 || offset - i > widest then i
    else if starts_declaration text i then if wanted = 0 then i else back (line_start text (i - 1)) (wanted - 1)
    else back (line_start text (i - 1)) wanted
  in
  back (line_start text offset) 2

let window_stop text offset =
  let rec forth i =
    match String.index_from_opt text i '\n' with
    | None -> String.length text
    | Some k when k - offset > widest -> k
    | Some k -> if starts_declaration text (k + 1) then k else forth (k + 1)
  in
  forth offset

let last_of text mark offset =
  let n = String.length mark in
  let rec find i =
    if i < 0 then -1
    else
      match String.rindex_from_opt text i mark.[0] with
      | None -> -1
      | Some k -> if k + n <= offset && String.sub text k n = mark then k else find (k - 1)
  in
  find (Int.min offset (String.length text) - n)

(* Comments, and quotation marks that are not closed yet. *)
let silent text (tokens : Tokens.t) offset start =
  let within from stop = from < offset && offset < stop in
  let in_comment (c : Trivia.t) =
    match c.kind with
    | Line -> start + c.start < offset && offset <= start + c.stop
    | Block -> within (start + c.start) (start + c.stop)
    | Blank -> false
  in
  let quoted (t : Tokens.token) =
    match t.token with STRING _ -> within (start + t.start) (start + t.stop) | _ -> false
  in
  let open_fault (d : Diag.t) =
    String.equal d.code (Code.unterminated :> string)
    && start + d.span.start < offset
    && not (String.contains (String.sub text (start + d.span.start) (offset - start - d.span.start)) '\n')
  in
  last_of text "/*" offset > last_of text "*/" offset
  || List.exists in_comment tokens.trivia
  || Array.exists quoted tokens.tokens
  || List.exists open_fault tokens.faults

let quoted (t : Tokens.token) = match t.token with STRING _ -> true | _ -> false

let window text offset =
  let start = window_start text offset in
  let part = String.sub text start (window_stop text offset - start) in
  let source = Source.make ~name:"window" part in
  (start, source, Tokens.read source)

let around text offset =
  let start, source, tokens = window text offset in
  if silent text tokens offset start then None
  else
    let place = offset - start and spelt = spelt source in
    let begun (t : Tokens.token) = t.start < place && place <= t.stop && is_name (spelt t) in
    let at = List.map (Array.get tokens.tokens) (Reading.tokens_at tokens place) in
    let from = match List.find_opt begun at with Some t -> t.start | None -> place in
    let kept (t : Tokens.token) = t.stop > t.start && (not (quoted t)) && not (t.start = from && begun t) in
    let all = List.filter kept (Array.to_list tokens.tokens) in
    let count = List.length (List.filter (fun (t : Tokens.token) -> t.start < from) all) in
    let words = Array.of_list (List.map spelt all) in
    Some (start + from, { words; count; items = items words })

let here t =
  List.fold_left (fun found i -> if i.first < t.count then Some i else found) None t.items

let first t = match here t with Some i -> i.first | None -> 0
let before t k = if t.count - k >= first t then t.words.(t.count - k) else ""

let bracket t =
  let rec find i depth =
    if i < first t then None
    else
      match t.words.(i) with
      | ")" | "]" | "}" -> find (i - 1) (depth + 1)
      | "(" | "[" | "{" -> if depth = 0 then Some i else find (i - 1) (depth - 1)
      | _ -> find (i - 1) depth
  in
  find (t.count - 1) 0
