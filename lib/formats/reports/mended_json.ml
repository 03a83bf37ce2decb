open Scc_json
open Scc_runs
open Json_format

let ways = [ "grid"; "weld"; "orient"; "merge"; "triangles" ]

let format =
  fields
    [
      field "by" (word Fun.id ways) fst ~about:"The option."; field "told" some_text snd ~about:"For people.";
    ]
  |> list ~least:1
  |> about "What was done to the mesh first, in order; there with these options alone."
  |> checked |> named ~file:Shared.file "mended"

let field = maybe "mended" format (function [] -> None | told -> Some told)
