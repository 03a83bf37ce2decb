open Scc_exact
open Scc_polyhedra

type variable = { index : int; name : string }
type t = { constant : Rat.t; terms : (variable * Rat.t) list }

let const constant = { constant; terms = [] }
let variable v = { constant = Rat.zero; terms = [ (v, Rat.one) ] }
let constant f = match f.terms with [] -> Some f.constant | _ :: _ -> None

let map f { constant; terms } = { constant = f constant; terms = List.map (fun (v, c) -> (v, f c)) terms }
let neg = map Rat.neg
let scale k f = if Rat.sign k = 0 then const Rat.zero else map (Rat.mul k) f

let rec sum_onto found a b =
  match (a, b) with
  | [], rest | rest, [] -> List.rev_append found rest
  | ((v, c) as first) :: a', ((w, d) as second) :: b' ->
    if v.index < w.index then sum_onto (first :: found) a' b
    else if w.index < v.index then sum_onto (second :: found) a b'
    else
      let e = Rat.add c d in
      sum_onto (if Rat.sign e = 0 then found else (v, e) :: found) a' b'

let sum a b = sum_onto [] a b

let add a b =
  match (a.terms, b.terms) with
  | [], [] -> const (Rat.add a.constant b.constant)
  | _ -> { constant = Rat.add a.constant b.constant; terms = sum a.terms b.terms }

let sub a b = add a (neg b)
let bits f = List.fold_left (fun n (_, c) -> n + Rat.bits c) (Rat.bits f.constant) f.terms
let names f = List.map (fun (v, _) -> v.name) f.terms

let eval f point =
  List.fold_left (fun total (v, c) -> Rat.add total (Rat.mul c point.(v.index))) f.constant f.terms

let linear n f = Linear.of_terms n ~constant:f.constant (List.map (fun (v, c) -> (v.index, c)) f.terms)

let to_string f =
  match f.terms with
  | [] -> Rat.to_string f.constant
  | terms ->
    let n = 1 + List.fold_left (fun n (v, _) -> Int.max n v.index) 0 terms in
    let name i = match List.find_opt (fun (v, _) -> v.index = i) terms with Some (v, _) -> v.name | None -> "" in
    Text.form ~name (linear n f)

type place = t * t * t

let place (v : Vec.t) = (const v.x, const v.y, const v.z)

let fixed (x, y, z) =
  match (constant x, constant y, constant z) with
  | Some x, Some y, Some z -> Some (Vec.make x y z)
  | _ -> None

let at point (x, y, z) = Vec.make (eval x point) (eval y point) (eval z point)
let add_place (a, b, c) (x, y, z) = (add a x, add b y, add c z)

let turned (m : Mat.t) (x, y, z) =
  let row (r : Vec.t) = add (scale r.x x) (add (scale r.y y) (scale r.z z)) in
  (row m.r0, row m.r1, row m.r2)
