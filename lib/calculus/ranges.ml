open Scc_exact
open Scc_polyhedra

type bound = { value : Rat.t; included : bool }
type range = { name : string; low : bound; high : bound }
type t = range array

let name ranges i = ranges.(i).name

let find ranges name =
  let rec from i =
    if i = Array.length ranges then None else if ranges.(i).name = name then Some i else from (i + 1)
  in
  from 0

let mem range x =
  let within (bound : bound) order = order < 0 || (bound.included && order = 0) in
  within range.low (Rat.compare range.low.value x) && within range.high (Rat.compare x range.high.value)

let box ranges =
  let n = Array.length ranges in
  let within i { low; high; _ } =
    let x = Linear.variable n i and constant (b : bound) = Linear.constant n b.value in
    [
      (if low.included then Constraint.at_least else Constraint.greater) x (constant low);
      (if high.included then Constraint.at_most else Constraint.less) x (constant high);
    ]
  in
  Polyhedron.of_constraints n (List.concat (Array.to_list (Array.mapi within ranges)))

let range_to_string { name; low; high } =
  Printf.sprintf "%s in %s%s, %s%s" name
    (if low.included then "[" else "(")
    (Rat.to_string low.value) (Rat.to_string high.value)
    (if high.included then "]" else ")")

let to_string ranges = String.concat ", " (List.map range_to_string (Array.to_list ranges))

let constant n = Linear.constant n Rat.zero

(* The least and the greatest value of a form, in the limit, and whether there is a point where it has them. *)
let extremes ranges (form : Linear.t) =
  let add i (value, attained) (low : bound) (high : bound) =
    let a = form.coefficients.(i) in
    let bound = if Rat.sign a > 0 then low else high in
    if Rat.sign a = 0 then (value, attained)
    else (Rat.add value (Rat.mul a bound.value), attained && bound.included)
  in
  let none = (form.constant, true) in
  let _, least, greatest =
    Array.fold_left
      (fun (i, least, greatest) { low; high; _ } -> (i + 1, add i least low high, add i greatest high low))
      (0, none, none) ranges
  in
  (least, greatest)

(* Those that a form depends on, and the form over them alone: a hundred others do not matter. *)
let concerned ranges (form : Linear.t) =
  let on = List.filter (fun i -> Rat.sign form.coefficients.(i) <> 0) (List.init (Array.length ranges) Fun.id) in
  let coefficients = List.mapi (fun k i -> (k, form.coefficients.(i))) on in
  let few = Array.of_list (List.map (fun i -> ranges.(i)) on) in
  (few, Linear.of_terms (Array.length few) ~constant:form.constant coefficients)

let negative ranges form =
  let (least, _), _ = extremes ranges form in
  if Rat.sign least >= 0 then None
  else
    let few, form = concerned ranges form in
    let named point = Array.to_list (Array.mapi (fun k (r : range) -> (r.name, point.(k))) few) in
    Polyhedron.interior_point (Polyhedron.add (box few) (Constraint.less form (constant (Array.length few))))
    |> Option.map named

let may_be_zero ranges form =
  let (least, least_attained), (greatest, greatest_attained) = extremes ranges form in
  match (Rat.sign least, Rat.sign greatest) with
  | 0, 0 -> true
  | 0, _ -> least_attained
  | _, 0 -> greatest_attained
  | below, above -> below < 0 && above > 0

let point ranges =
  let simplest r =
    match Polyhedron.interior_point (box [| r |]) with
    | Some p -> p.(0)
    | None -> Scc_base.Bug.fail __POS__ "a range without numbers"
  in
  Array.map simplest ranges
