open Scc_exact
open Scc_calculus
open Property

let next c rest = if c <> 0 then c else rest ()
let pair (a, b) (c, d) = next (Int.compare a c) (fun () -> Int.compare b d)
let axis_rank = function X -> 0 | Y -> 1 | Z -> 2
let axis a b = Int.compare (axis_rank a) (axis_rank b)

let comparison_rank : Law.comparison -> int = function
  | Lt -> 0
  | Le -> 1
  | Gt -> 2
  | Ge -> 3
  | Eq -> 4
  | Ne -> 5

let comparison a b = Int.compare (comparison_rank a) (comparison_rank b)
let polarity_rank : Behaviour.polarity -> int = function Name -> 0 | Co_name -> 1
let polarity a b = Int.compare (polarity_rank a) (polarity_rank b)

let change_rank = function
  | Made -> 0
  | Released_weakly -> 1
  | Released_strongly -> 2
  | Released -> 3

let ends_rank = function Any -> 0 | One _ -> 1 | Two _ -> 2

let ends a b =
  match (a, b) with
  | One i, One j -> Int.compare i j
  | Two (i, j), Two (k, l) -> pair (i, j) (k, l)
  | (Any | One _ | Two _), _ -> Int.compare (ends_rank a) (ends_rank b)

let event a b =
  match (a, b) with
  | Bond (c, n, e), Bond (d, o, f) ->
    next (Int.compare (change_rank c) (change_rank d)) (fun () ->
        next (Option.compare String.compare n o) (fun () -> ends e f))
  | Bounce e, Bounce f -> ends e f
  | Bond _, Bounce _ -> -1
  | Bounce _, Bond _ -> 1

let num_rank = function
  | Const _ -> 0
  | Bonds _ -> 1
  | Size _ -> 2
  | Processes -> 3
  | Position _ -> 4
  | Velocity _ -> 5
  | Speed2 _ -> 6
  | Distance2 _ -> 7
  | Momentum _ -> 8
  | Energy -> 9
  | Time -> 10
  | Count _ -> 11
  | Neg _ -> 12
  | Add _ -> 13
  | Sub _ -> 14
  | Mul _ -> 15
  | Div _ -> 16
  | If _ -> 17
  | Spin _ -> 18
  | Spin2 _ -> 19
  | Angular _ -> 20

let prop_rank = function
  | Bool _ -> 0
  | Compare _ -> 1
  | Bound _ -> 2
  | Same _ -> 3
  | Behaviour _ -> 4
  | Offers _ -> 5
  | Touching _ -> 6
  | Quiescent -> 7
  | Event _ -> 8
  | Not _ -> 9
  | And _ -> 10
  | Or _ -> 11

(* Constructors without arguments are equal to themselves by their ranks. *)
let rec num a b =
  match (a, b) with
  | Const x, Const y -> Rat.compare x y
  | Bonds (n, p), Bonds (o, q) ->
    next (Option.compare String.compare n o) (fun () -> Option.compare pair p q)
  | Size i, Size j | Speed2 i, Speed2 j | Spin2 i, Spin2 j -> Int.compare i j
  | Position (x, i), Position (y, j) | Velocity (x, i), Velocity (y, j)
  | Spin (x, i), Spin (y, j) ->
    next (axis x y) (fun () -> Int.compare i j)
  | Distance2 (i, j), Distance2 (k, l) -> pair (i, j) (k, l)
  | Momentum x, Momentum y | Angular x, Angular y -> axis x y
  | Count ps, Count qs -> List.compare prop ps qs
  | Neg a, Neg b -> num a b
  | Add (a, b), Add (c, d) | Sub (a, b), Sub (c, d) | Mul (a, b), Mul (c, d) | Div (a, b), Div (c, d) ->
    next (num a c) (fun () -> num b d)
  | If (p, a, b), If (q, c, d) -> next (prop p q) (fun () -> next (num a c) (fun () -> num b d))
  | ( ( Const _ | Bonds _ | Size _ | Speed2 _ | Spin _ | Spin2 _ | Processes | Energy | Time | Position _
      | Velocity _ | Distance2 _ | Momentum _ | Angular _ | Count _ | Neg _ | Add _ | Sub _ | Mul _ | Div _
      | If _ ),
      _ ) -> Int.compare (num_rank a) (num_rank b)

and prop a b =
  match (a, b) with
  | Bool x, Bool y -> Bool.compare x y
  | Compare (c, a, b), Compare (d, e, f) ->
    next (comparison c d) (fun () -> next (num a e) (fun () -> num b f))
  | Bound (i, j), Bound (k, l) | Same (i, j), Same (k, l) | Touching (i, j), Touching (k, l)
  | Behaviour (i, j), Behaviour (k, l) -> pair (i, j) (k, l)
  | Offers (i, p, a), Offers (j, q, b) ->
    next (Int.compare i j) (fun () ->
        next (Option.compare polarity p q) (fun () -> String.compare a b))
  | Event e, Event f -> event e f
  | Not p, Not q -> prop p q
  | And ps, And qs | Or ps, Or qs -> List.compare prop ps qs
  | ( ( Bool _ | Compare _ | Bound _ | Same _ | Touching _ | Behaviour _ | Offers _ | Quiescent | Event _
      | Not _ | And _ | Or _ ),
      _ ) -> Int.compare (prop_rank a) (prop_rank b)

let quantifier = Scc_ctl.Formula.compare_quantifier
let bound = Scc_ctl.Formula.compare_bound

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
