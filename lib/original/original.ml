open Scc_base
open Scc_syntax

let tokens source =
  let name = Source.name source and text = Source.text source in
  let whole (t : Tokens.token) =
    match t.token with
    | PLUS | STAR | MINUS -> { t with stop = t.start + Signs.length text t.start }
    | _ -> t
  in
  let rewrite tokens = Words.rewrite ~file:name (Array.map whole tokens) in
  Tokens.read ~rewrite (Source.make ~name (Signs.spelt text))

let ( let* ) = Result.bind
let tree source = Parse.with_trivia ~tokens source

let read source =
  let* items, trivia = tree source in
  let* items = Refine.model items in
  Ok (items, trivia)

let write (items, trivia) =
  let* items = Abstract.model items in
  Ok (Written.model ~trivia items)

let canonical source =
  let* items, trivia = tree source in
  match List.sort_uniq Diag.compare (Region.faults items) with
  | [] -> Ok (Written.model ~trivia items)
  | faults -> Error faults

let readable source = Parse.readable ~tokens source
