open Scc_exact
open Scc_calculus
open Property

let comparison (a : Law.comparison) b = compare a b
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
  | _ -> Int.compare (num_rank a) (num_rank b) <?> fun () -> parts (Parts.of_num a) (Parts.of_num b)

and prop a b =
  match (a, b) with
  | Bool x, Bool y -> Bool.compare x y
  | Fact x, Fact y -> fact x y
  | Compare (c, _, _), Compare (d, _, _) when c <> d -> comparison c d
  | _ -> Int.compare (prop_rank a) (prop_rank b) <?> fun () -> parts (Parts.of_prop a) (Parts.of_prop b)

and parts { numbers; predicates } (others : Parts.t) =
  List.compare prop predicates others.predicates <?> fun () -> List.compare num numbers others.numbers

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
  | Next (q, f), Next (r, g) -> quantifier q r <?> fun () -> temporal f g
  | Finally (q, b, f), Finally (r, c, g) | Globally (q, b, f), Globally (r, c, g) ->
    quantifier q r <?> fun () -> bound b c <?> fun () -> temporal f g
  | Until (q, b, f, g), Until (r, c, h, i) ->
    quantifier q r <?> fun () -> bound b c <?> fun () -> temporal f h <?> fun () -> temporal g i
  | ( ( State _ | Temporal_not _ | Temporal_and _ | Temporal_or _ | Next _ | Finally _ | Globally _
      | Until _ ),
      _ ) -> Int.compare (temporal_rank a) (temporal_rank b)
