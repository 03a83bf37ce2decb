open Scc_exact
open Scc_calculus
open Property

(* A constant, and terms with their factors. *)
type combination = { constant : Rat.t; terms : (num * Rat.t) list }

let const constant = { constant; terms = [] }
let term n = { constant = Rat.zero; terms = [ (Rename.ordered_num n, Rat.one) ] }
let add a b = { constant = Rat.add a.constant b.constant; terms = List.rev_append b.terms a.terms }
let scale k a = { constant = Rat.mul k a.constant; terms = List.map (fun (n, f) -> (n, Rat.mul k f)) a.terms }
let opposite = scale (Rat.of_int (-1))
let is_const c = c.terms = []

(* Each term once, in order. A factor of 0 stays, as its term may be undefined. *)
let collected terms =
  let put found (n, f) =
    match found with
    | (m, g) :: rest when Order.num m n = 0 -> (m, Rat.add f g) :: rest
    | _ -> (n, f) :: found
  in
  List.rev (List.fold_left put [] (List.stable_sort (fun (m, _) (n, _) -> Order.num m n) terms))

let sum terms =
  let scaled (n, factor) = if Rat.equal factor Rat.one then n else Mul (Const factor, n) in
  match List.map scaled (collected terms) with
  | [] -> Const Rat.zero
  | n :: rest -> List.fold_left (fun a b -> Add (a, b)) n rest

let written c = if is_const c then Const c.constant else Add (Const c.constant, sum c.terms)

let mirrored : Law.comparison -> Law.comparison = function
  | Lt -> Gt
  | Le -> Ge
  | Gt -> Lt
  | Ge -> Le
  | (Eq | Ne) as c -> c

(* The first factor that is not 0; 1 if there is none. *)
let lead terms =
  match List.find_opt (fun (_, f) -> Rat.sign f <> 0) (collected terms) with None -> Rat.one | Some (_, f) -> f

let compared c a =
  let lead = lead a.terms in
  let c = if Rat.sign lead < 0 then mirrored c else c in
  let scaled = scale (Rat.div Rat.one lead) a in
  Compare (c, sum scaled.terms, Const (Rat.neg scaled.constant))

let rec combination n =
  match n with
  | Const c -> const c
  | Quantity _ -> term n
  | Neg a -> opposite (combination a)
  | Add (a, b) -> add (combination a) (combination b)
  | Sub (a, b) -> add (combination a) (opposite (combination b))
  | Mul (a, b) -> product (combination a) (combination b)
  | Div (a, b) -> (
      match (combination a, combination b) with
      | a, b when is_const b && Rat.sign b.constant <> 0 -> scale (Rat.div Rat.one b.constant) a
      | a, b -> term (Div (written a, written b)))
  | Count ps -> term (Count (List.map prop ps))
  | If (p, a, b) -> term (If (prop p, num a, num b))

and product a b =
  if is_const a then scale a.constant b
  else if is_const b then scale b.constant a
  else
    let p = lead a.terms and q = lead b.terms in
    let simple lead c = written (scale (Rat.div Rat.one lead) c) in
    scale (Rat.mul p q) (term (Mul (simple p a, simple q b)))

and num n = Rename.ordered_num (written (combination n))

and prop p =
  match p with
  | Compare (c, a, b) -> Rename.ordered_prop (compared c (add (combination a) (opposite (combination b))))
  | Not (Fact _) | Bool _ | Fact _ -> Rename.ordered_prop p
  | Not q -> prop (Formula.negate q)
  | And ps -> Rename.ordered_prop (And (List.map prop ps))
  | Or ps -> Rename.ordered_prop (Or (List.map prop ps))
