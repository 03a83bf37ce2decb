open Scc_base
open Scc_exact
open Scc_syntax
module Names = Map.Make (String)

type value = Number of Rat.t | Truth of bool | Macro of Ast.expr * t | Leaf of int
and binding = { value : value; span : Span.t; mutable used : bool }
and t = binding Names.t

let empty = Names.empty
let add = Names.add

let find env name =
  match Names.find_opt name env with
  | None -> None
  | Some b ->
    b.used <- true;
    Some b.value

let names env = List.map fst (Names.bindings env)
