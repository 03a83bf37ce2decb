open Scc_exact
open Property

type t = Never | Until of Rat.t | Always

let join a b =
  match (a, b) with
  | Always, _ | _, Always -> Always
  | Never, x | x, Never -> x
  | Until s, Until t -> Until (Rat.max s t)

let join_all f list = List.fold_left (fun seen x -> join seen (f x)) Never list

(* [Some (a, b)] when the number is a * time + b. *)
let rec linear = function
  | Const b -> Some (Rat.zero, b)
  | Quantity Time -> Some (Rat.one, Rat.zero)
  | Neg n -> Option.map (fun (a, b) -> (Rat.neg a, Rat.neg b)) (linear n)
  | Add (m, n) -> both (fun (a, b) (c, d) -> Some (Rat.add a c, Rat.add b d)) m n
  | Sub (m, n) -> both (fun (a, b) (c, d) -> Some (Rat.sub a c, Rat.sub b d)) m n
  | Mul (m, n) ->
    let product (a, b) (c, d) =
      if Rat.sign a = 0 then Some (Rat.mul b c, Rat.mul b d)
      else if Rat.sign c = 0 then Some (Rat.mul a d, Rat.mul b d)
      else None
    in
    both product m n
  | Div (m, n) ->
    let quotient (a, b) (c, d) =
      if Rat.sign c = 0 && Rat.sign d <> 0 then Some (Rat.div a d, Rat.div b d) else None
    in
    both quotient m n
  | Quantity _ | Count _ | If _ -> None

and both f m n =
  match (linear m, linear n) with
  | Some x, Some y -> f x y
  | None, _ | _, None -> None

let atom a = if Atom.depends_on Absolute_time a then Always else Never

let rec num = function
  | Const _ -> Never
  | Quantity q -> atom (Atom.quantity q)
  | Count ps -> join_all prop ps
  | Neg n -> num n
  | Add (m, n) | Sub (m, n) | Mul (m, n) | Div (m, n) -> join (num m) (num n)
  | If (p, m, n) -> join (prop p) (join (num m) (num n))

and prop = function
  | Compare (_, m, n) -> (
      match linear (Sub (m, n)) with
      | Some (a, _) when Rat.sign a = 0 -> Never
      | Some (a, b) -> Until (Rat.max Rat.zero (Rat.div (Rat.neg b) a))
      | None -> join (num m) (num n))
  | Not p -> prop p
  | And ps | Or ps -> join_all prop ps
  | Fact f -> atom (Atom.fact f)
  | Bool _ -> Never

let formula f = join_all prop (Formula.predicates f)
let formulas list = join_all formula list

let same_kind a b =
  match (a, b) with
  | Never, Never | Until _, Until _ | Always, Always -> true
  | (Never | Until _ | Always), _ -> false

let beyond seen time =
  match seen with
  | Until c when Rat.compare time c > 0 -> Some c
  | Never | Until _ | Always -> None

let representative seen time =
  match (seen, beyond seen time) with
  | Never, _ -> Rat.zero
  | _, Some c -> Rat.add c Rat.one
  | (Until _ | Always), None -> time
