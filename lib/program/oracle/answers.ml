open Scc_exact
open Scc_semantics
open Scc_json
open Scc_runs
open Json_format

let named name t = named ~file:Read.file name t
let shape = named "shape" (Shared.numbered "s")
let model = named "model" (Shared.numbered "m")
let path = list natural |> about "Choices from the initial state on." |> named "path"
let rules = from (List.map Rule.id) (list ~least:1 text) |> named "rules"

let quantity =
  let double q : Json.t =
    let x = Rat.to_float q in
    if Float.is_finite x then `Float x else `Null
  in
  let schema = Json_schema.Also ([ ("type", `List [ `String "number"; `String "null" ]) ], Anything) in
  fields [ field "exact" Shared.rational Fun.id; field "float" (json ~schema ()) double ]
  |> about "A number of an answer with the nearest double, null when there is none." |> named "quantity"

let released handle = fields [ field "released" handle Fun.id ]
