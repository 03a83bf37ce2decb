open Scc_data
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate

type sum = { quantity : Property.quantity; part : State.process -> int; mutable value : int }
type t = sum list

let make semantics atoms =
  let sum (a : Atom.t) =
    match Option.map (fun q -> (q, Meaning.quantity (Semantics.model semantics) q)) a.total with
    | Some (quantity, Number (_, part)) -> Some { quantity; part; value = 0 }
    | Some _ | None -> None
  in
  List.filter_map sum (Lists.distinct (fun a b -> Atom.compare a b = 0) atoms)

let count t (s : State.t) =
  List.iter (fun sum -> sum.value <- Array.fold_left (fun n p -> n + sum.part p) 0 s.processes) t

let is_empty = function [] -> true | _ :: _ -> false

let replace t ~gone ~come =
  let change sum =
    let all = List.fold_left (fun n p -> n + sum.part p) 0 in
    sum.value <- sum.value + all come - all gone
  in
  List.iter change t

let value t quantity =
  let is_it sum = Formula.equal_num (Quantity sum.quantity) (Quantity quantity) in
  Option.map (fun sum -> sum.value) (List.find_opt is_it t)
