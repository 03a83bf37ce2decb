open Scc_exact
open Scc_calculus
open Property

let next c rest = if c <> 0 then c else rest ()
let comparison_rank : Law.comparison -> int = function
  | Lt -> 0
  | Le -> 1
  | Gt -> 2
  | Ge -> 3
  | Eq -> 4
  | Ne -> 5

let comparison a b = Int.compare (comparison_rank a) (comparison_rank b)

let quantity a b = Atom.compare (Atom.quantity a) (Atom.quantity b)
let fact a b = Atom.compare (Atom.fact a) (Atom.fact b)
let event a b = fact (Event a) (Event b)

let num_rank = function
  | Const _ -> 0
  | Quantity _ -> 1
  | Count _ -> 2
  | Neg _ -> 3
  | Add _ -> 4
  | Sub _ -> 5
  | Mul _ -> 6
  | Div _ -> 7
  | If _ -> 8

let prop_rank = function
  | Bool _ -> 0
  | Compare _ -> 1
  | Fact _ -> 2
  | Not _ -> 3
  | And _ -> 4
  | Or _ -> 5

let rec num a b =
  match (a, b) with
  | Const x, Const y -> Rat.compare x y
  | Quantity x, Quantity y -> quantity x y
  | Count ps, Count qs -> List.compare prop ps qs
  | Neg a, Neg b -> num a b
  | Add (a, b), Add (c, d) | Sub (a, b), Sub (c, d) | Mul (a, b), Mul (c, d) | Div (a, b), Div (c, d) ->
    next (num a c) (fun () -> num b d)
  | If (p, a, b), If (q, c, d) -> next (prop p q) (fun () -> next (num a c) (fun () -> num b d))
  | (Const _ | Quantity _ | Count _ | Neg _ | Add _ | Sub _ | Mul _ | Div _ | If _), _ ->
    Int.compare (num_rank a) (num_rank b)

and prop a b =
  match (a, b) with
  | Bool x, Bool y -> Bool.compare x y
  | Compare (c, a, b), Compare (d, e, f) ->
    next (comparison c d) (fun () -> next (num a e) (fun () -> num b f))
  | Fact x, Fact y -> fact x y
  | Not p, Not q -> prop p q
  | And ps, And qs | Or ps, Or qs -> List.compare prop ps qs
  | (Bool _ | Compare _ | Fact _ | Not _ | And _ | Or _), _ -> Int.compare (prop_rank a) (prop_rank b)

let quantifier = Scc_ctl.Timed_formula.compare_quantifier
let bound = Scc_ctl.Timed_formula.compare_bound

let temporal_rank = function
  | State _ -> 0
  | Temporal_not _ -> 1
  | Temporal_and _ -> 2
  | Temporal_or _ -> 3
  | Next _ -> 4
  | Finally _ -> 5
  | Globally _ -> 6
  | Until _ -> 7

let rec temporal a b =
  match (a, b) with
  | State p, State q -> prop p q
  | Temporal_not f, Temporal_not g -> temporal f g
  | Temporal_and fs, Temporal_and gs | Temporal_or fs, Temporal_or gs -> List.compare temporal fs gs
  | Next (q, f), Next (r, g) -> next (quantifier q r) (fun () -> temporal f g)
  | Finally (q, b, f), Finally (r, c, g) | Globally (q, b, f), Globally (r, c, g) ->
    next (quantifier q r) (fun () -> next (bound b c) (fun () -> temporal f g))
  | Until (q, b, f, g), Until (r, c, h, i) ->
    next (quantifier q r) (fun () ->
        next (bound b c) (fun () -> next (temporal f h) (fun () -> temporal g i)))
  | ( ( State _ | Temporal_not _ | Temporal_and _ | Temporal_or _ | Next _ | Finally _ | Globally _
      | Until _ ),
      _ ) -> Int.compare (temporal_rank a) (temporal_rank b)
