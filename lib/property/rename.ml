open Scc_base
open Property

let rec num f = function
  | (Const _ | Processes | Momentum _ | Angular _ | Energy | Time | Bonds (_, None)) as n -> n
  | Bonds (a, Some (i, j)) -> Bonds (a, Some (f i, f j))
  | Size i -> Size (f i)
  | Position (a, i) -> Position (a, f i)
  | Velocity (a, i) -> Velocity (a, f i)
  | Speed2 i -> Speed2 (f i)
  | Spin (a, i) -> Spin (a, f i)
  | Spin2 i -> Spin2 (f i)
  | Distance2 (i, j) -> Distance2 (f i, f j)
  | Count ps -> Count (Long_list.map (prop f) ps)
  | Neg a -> Neg (num f a)
  | Add (a, b) -> Add (num f a, num f b)
  | Sub (a, b) -> Sub (num f a, num f b)
  | Mul (a, b) -> Mul (num f a, num f b)
  | Div (a, b) -> Div (num f a, num f b)
  | If (p, a, b) -> If (prop f p, num f a, num f b)

and prop f = function
  | (Bool _ | Quiescent) as p -> p
  | Compare (c, a, b) -> Compare (c, num f a, num f b)
  | Bound (i, j) -> Bound (f i, f j)
  | Same (i, j) -> Same (f i, f j)
  | Behaviour (i, k) -> Behaviour (f i, k)
  | Offers (i, p, a) -> Offers (f i, p, a)
  | Touching (i, j) -> Touching (f i, f j)
  | Event (Bond (change, a, e)) -> Event (Bond (change, a, ends f e))
  | Event (Bounce e) -> Event (Bounce (ends f e))
  | Not p -> Not (prop f p)
  | And ps -> And (Long_list.map (prop f) ps)
  | Or ps -> Or (Long_list.map (prop f) ps)

and ends f = function
  | Any -> Any
  | One i -> One (f i)
  | Two (i, j) -> Two (f i, f j)

(* A temporal formula with its predicates mapped. *)
let rec states f = function
  | State p -> State (f p)
  | Temporal_not g -> Temporal_not (states f g)
  | Temporal_and gs -> Temporal_and (Long_list.map (states f) gs)
  | Temporal_or gs -> Temporal_or (Long_list.map (states f) gs)
  | Next (q, g) -> Next (q, states f g)
  | Finally (q, b, g) -> Finally (q, b, states f g)
  | Globally (q, b, g) -> Globally (q, b, states f g)
  | Until (q, b, g, h) -> Until (q, b, states f g, states f h)

let temporal f g = states (prop f) g

(* {1 One form of formulas that differ in order alone} *)

let ordered_pair (i, j) = if i <= j then (i, j) else (j, i)

let ordered_ends = function
  | (Any | One _) as e -> e
  | Two (i, j) ->
    let i, j = ordered_pair (i, j) in
    Two (i, j)

(* The operands of a chain of one associative operator, whatever its brackets. *)
let flatten operands x =
  let rec go found = function
    | [] -> found
    | x :: rest -> (
        match operands x with
        | Some xs -> go found (List.rev_append (List.rev xs) rest)
        | None -> go (x :: found) rest)
  in
  go [] [ x ]

let summands = function Add (a, b) -> Some [ a; b ] | _ -> None
let factors = function Mul (a, b) -> Some [ a; b ] | _ -> None
let conjuncts = function And ps -> Some ps | _ -> None
let disjuncts = function Or ps -> Some ps | _ -> None
let temporal_conjuncts = function Temporal_and fs -> Some fs | _ -> None
let temporal_disjuncts = function Temporal_or fs -> Some fs | _ -> None

let rebuild make = function
  | [] -> Bug.fail __POS__ "an operator without operands"
  | x :: rest -> List.fold_left make x rest

let rec ordered_num n =
  match n with
  | Const _ | Processes | Momentum _ | Angular _ | Energy | Time | Bonds (_, None) | Size _ | Position _
  | Velocity _ | Speed2 _ | Spin _ | Spin2 _ -> n
  | Bonds (a, Some ends) -> Bonds (a, Some (ordered_pair ends))
  | Distance2 (i, j) ->
    let i, j = ordered_pair (i, j) in
    Distance2 (i, j)
  | Count ps -> Count (sorted_props ps)
  | Neg a -> Neg (ordered_num a)
  | Add _ -> rebuild (fun a b -> Add (a, b)) (sorted_nums (flatten summands n))
  | Mul _ -> rebuild (fun a b -> Mul (a, b)) (sorted_nums (flatten factors n))
  | Sub (a, b) -> Sub (ordered_num a, ordered_num b)
  | Div (a, b) -> Div (ordered_num a, ordered_num b)
  | If (p, a, b) -> If (ordered_prop p, ordered_num a, ordered_num b)

and sorted_nums ns = List.sort Order.num (Long_list.map ordered_num ns)
and sorted_props ps = List.sort Order.prop (Long_list.map ordered_prop ps)

and ordered_prop p =
  match p with
  | Bool _ | Quiescent | Behaviour _ | Offers _ -> p
  | Compare (Gt, a, b) -> Compare (Lt, ordered_num b, ordered_num a)
  | Compare (Ge, a, b) -> Compare (Le, ordered_num b, ordered_num a)
  | Compare (((Lt | Le) as c), a, b) -> Compare (c, ordered_num a, ordered_num b)
  | Compare (((Eq | Ne) as c), a, b) ->
    let a = ordered_num a and b = ordered_num b in
    if Order.num a b <= 0 then Compare (c, a, b) else Compare (c, b, a)
  | Bound (i, j) ->
    let i, j = ordered_pair (i, j) in
    Bound (i, j)
  | Same (i, j) ->
    let i, j = ordered_pair (i, j) in
    Same (i, j)
  | Touching (i, j) ->
    let i, j = ordered_pair (i, j) in
    Touching (i, j)
  | Event (Bond (change, a, e)) -> Event (Bond (change, a, ordered_ends e))
  | Event (Bounce e) -> Event (Bounce (ordered_ends e))
  | Not p -> Not (ordered_prop p)
  | And _ -> And (sorted_props (flatten conjuncts p))
  | Or _ -> Or (sorted_props (flatten disjuncts p))

let rec ordered f =
  match f with
  | State p -> State (ordered_prop p)
  | Temporal_not f -> Temporal_not (ordered f)
  | Temporal_and _ -> Temporal_and (sorted (flatten temporal_conjuncts f))
  | Temporal_or _ -> Temporal_or (sorted (flatten temporal_disjuncts f))
  | Next (q, f) -> Next (q, ordered f)
  | Finally (q, b, f) -> Finally (q, b, ordered f)
  | Globally (q, b, f) -> Globally (q, b, ordered f)
  | Until (q, b, f, g) -> Until (q, b, ordered f, ordered g)

and sorted fs = List.sort Order.temporal (Long_list.map ordered fs)
