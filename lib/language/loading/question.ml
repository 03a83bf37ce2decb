open Scc_base
open Scc_syntax
open Scc_property

type t = State of Property.prop | Number of Property.num | Temporal of Property.check

(* A check takes temporal formulas only, and says so of a state predicate. Whatever else it does not take is a
   number, or wrong: then a comparison takes it, or not. *)
type form = As_it_is | Possibly | Compared

let name = function As_it_is -> "check" | Possibly -> "state" | Compared -> "number"
let ast at it = { Ast.it; at }
let possibly (e : Ast.expr) = ast e.at (Ast.Temporal (Possibly, None, e))

(* The other side is no constant, so that the comparison stays one. *)
let compared (e : Ast.expr) =
  let time = ast e.at (Ast.Path (ast e.at [ { Ast.name = ast e.at "time"; indices = [] } ])) in
  possibly (ast e.at (Ast.Binary (Le, e, time)))

(* No name of the language looks like these. *)
let check_name number = Printf.sprintf "(formula %d)" number

let numbered number form (e : Ast.expr) =
  let written = match form with As_it_is -> e | Possibly -> possibly e | Compared -> compared e in
  ast e.at (Ast.Check (ast e.at (check_name number), written))

let item form e = numbered 0 form e

let of_check form (c : Property.check) =
  match (form, c.formula) with
  | As_it_is, _ -> Some (Temporal { c with name = "formula" })
  | Possibly, Finally (_, _, State p) -> Some (State p)
  | Compared, Finally (_, _, State (Compare (_, n, Quantity Time))) -> Some (Number n)
  | (Possibly | Compared), _ -> None

let rec last = function
  | [] -> Bug.fail __POS__ "the check of the formula is missing"
  | [ (c : Property.check) ] -> c
  | _ :: rest -> last rest

let is_state_formula = function
  | [ (d : Diag.t) ] -> String.equal d.code (Code.not_a_formula :> string)
  | _ -> false

(* The diagnostics of the first form: that is how the formula is written. *)
let formed ~model load =
  let meant form l = Option.map (fun q -> (form, l, q)) (of_check form (last (model l).Loaded.checks)) in
  match load As_it_is with
  | Ok l -> Option.to_result ~none:[] (meant As_it_is l)
  | Error diagnostics when is_state_formula diagnostics -> (
      match load Possibly with
      | Error diagnostics -> Error diagnostics
      | Ok l -> (
          match meant Possibly l with
          | Some found -> Ok found
          | None -> Bug.fail __POS__ "a state predicate is none"))
  | Error diagnostics -> (
      match load Compared with
      | Error _ -> Error diagnostics
      | Ok l -> Option.to_result ~none:diagnostics (meant Compared l))

let ask ~model load = Result.map (fun (_, l, q) -> (l, q)) (formed ~model load)

(* What each is by itself, then all of them in one model. *)
let all (l : Loaded.t) sources =
  let read = Scc_syntax.Parse.expression in
  let form source =
    let* e = read source in
    let* form, _, _ = formed ~model:Fun.id (fun form -> Loaded.with_checks l [ item form e ]) in
    Ok (form, e)
  in
  let* forms = Result.all form sources in
  let* l = Loaded.with_checks l (List.mapi (fun i (form, e) -> numbered i form e) forms) in
  let before = List.length l.checks - List.length forms in
  let checks = List.filteri (fun i _ -> i >= before) l.checks in
  let meant (form, _) check =
    match of_check form check with
    | Some q -> q
    | None -> Bug.fail __POS__ "a formula means something else beside others"
  in
  Ok (l, List.map2 meant forms checks)
