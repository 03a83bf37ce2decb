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

let values_to_string ranges values =
  let one r v = Printf.sprintf "%s = %s" r.name (Rat.to_string v) in
  String.concat ", " (Array.to_list (Array.map2 one ranges values))

let range_to_string { name; low; high } =
  Printf.sprintf "%s in %s%s, %s%s" name
    (if low.included then "[" else "(")
    (Rat.to_string low.value) (Rat.to_string high.value)
    (if high.included then "]" else ")")

let to_string ranges = String.concat ", " (List.map range_to_string (Array.to_list ranges))

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

(* One after the other, each as simple as leaves the least value of the form negative. A linear program over all of
   them comes to the same, and takes half a minute for a hundred. *)
let negative ranges (form : Linear.t) =
  let fix (least, named) i =
    let a = form.coefficients.(i) and range = ranges.(i) in
    if Rat.sign a = 0 then (least, named)
    else
      let bound = if Rat.sign a > 0 then range.low else range.high in
      let others = Rat.sub least (Rat.mul a bound.value) in
      let below = Constraint.less (Linear.of_terms 1 ~constant:others [ (0, a) ]) (Linear.constant 1 Rat.zero) in
      match Polyhedron.interior_point (Polyhedron.add (box [| range |]) below) with
      | Some p -> (Rat.add others (Rat.mul a p.(0)), (range.name, p.(0)) :: named)
      | None -> Scc_base.Bug.fail __POS__ "a negative least value that nothing comes near"
  in
  let (least, _), _ = extremes ranges form in
  if Rat.sign least >= 0 then None
  else Some (List.rev (snd (List.fold_left fix (least, []) (List.init (Array.length ranges) Fun.id))))

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
