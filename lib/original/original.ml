open Scc_base
open Scc_syntax

let tokens source =
  let spelt = Source.make ~name:(Source.name source) (Signs.spelt (Source.text source)) in
  Tokens.read ~rewrite:(Words.rewrite ~file:(Source.name source)) spelt

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
  Ok (Written.model ~trivia items)

let readable source = Parse.readable ~tokens source
