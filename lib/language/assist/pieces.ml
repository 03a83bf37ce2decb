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

(* `bonds(rope)` and `<bond, …>` begin nothing, nor does a loop within a choice. *)
let begins_at words i =
  let next = if i + 1 < Array.length words then words.(i + 1) else "" in
  let before = if i > 0 then words.(i - 1) else "" in
  begins words.(i)
  && (not (List.mem before [ "<"; "~"; ","; "("; "."; "{" ]))
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

let quoted (t : Tokens.token) = match t.token with STRING _ -> true | _ -> false

(* Comments, and quotation marks that are not closed yet. *)
let silent (r : Reading.t) (tokens : Tokens.t) offset =
  let within start stop = start < offset && offset < stop in
  let in_comment (c : Trivia.t) =
    match c.kind with Line -> c.start < offset && offset <= c.stop | Block -> within c.start c.stop | Blank -> false
  in
  let text = Source.text r.source in
  let line = match String.rindex_from_opt text (offset - 1) '\n' with Some i -> i + 1 | None -> 0 | exception Invalid_argument _ -> 0 in
  let open_fault (d : Diag.t) =
    String.equal d.code (Code.unterminated :> string) && d.span.start < offset
    && (d.span.start >= line || String.length text > d.span.start && text.[d.span.start] = '/')
  in
  List.exists in_comment tokens.trivia
  || Array.exists (fun (t : Tokens.token) -> quoted t && within t.start t.stop) tokens.tokens
  || List.exists open_fault tokens.faults

let around (r : Reading.t) offset =
  let tokens = Lazy.force r.tokens in
  if silent r tokens offset then None
  else
    let text = spelt r.source in
    let begun (t : Tokens.token) = t.start < offset && offset <= t.stop && is_name (text t) in
    let from = match List.find_opt begun (List.map (Array.get tokens.tokens) (Reading.tokens_at tokens offset)) with
      | Some t -> t.start
      | None -> offset
    in
    let kept (t : Tokens.token) = not (t.start = from && begun t) && not (quoted t) && t.stop > t.start in
    let all = List.filter kept (Array.to_list tokens.tokens) in
    let count = List.length (List.filter (fun (t : Tokens.token) -> t.start < from) all) in
    let words = Array.of_list (List.map text all) in
    Some (from, { words; count; items = items words })

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
