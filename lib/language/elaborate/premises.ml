open Scc_syntax
open Ast

type found = { premise : expr; bound : bound option; around : expr -> expr }

let rec below_always bound around (e : expr) =
  match e.it with
  | Binary (Implies, premise, _) -> [ { premise; bound; around } ]
  | Binary (And, f, g) -> below_always bound around f @ below_always bound around g
  | Quantified (Forall, v, template, body) ->
    let around inner = around { e with it = Quantified (Exists, v, template, inner) } in
    below_always bound around body
  | _ -> []

let rec top (e : expr) =
  match e.it with
  | Temporal ((Always | Globally A), bound, body) -> below_always bound Fun.id body
  | Leads_to (premise, _, _) -> [ { premise; bound = None; around = Fun.id } ]
  | Binary (And, f, g) -> top f @ top g
  | _ -> []

let of_check e =
  List.map
    (fun f ->
       let possibly = { f.premise with it = Temporal (Finally E, f.bound, f.around f.premise) } in
       (f.premise, possibly))
    (top e)
