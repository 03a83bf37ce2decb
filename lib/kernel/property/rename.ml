open Scc_base
open Property

let rec num f = function
  | Const _ as n -> n
  | Quantity q -> Quantity (Atom.renamed_quantity f q)
  | Count ps -> Count (List.map (prop f) ps)
  | Neg a -> Neg (num f a)
  | Add (a, b) -> Add (num f a, num f b)
  | Sub (a, b) -> Sub (num f a, num f b)
  | Mul (a, b) -> Mul (num f a, num f b)
  | Div (a, b) -> Div (num f a, num f b)
  | If (p, a, b) -> If (prop f p, num f a, num f b)

and prop f = function
  | Bool _ as p -> p
  | Compare (c, a, b) -> Compare (c, num f a, num f b)
  | Fact x -> Fact (Atom.renamed_fact f x)
  | Not p -> Not (prop f p)
  | And ps -> And (List.map (prop f) ps)
  | Or ps -> Or (List.map (prop f) ps)

(* A temporal formula with its predicates mapped. *)
let rec states f = function
  | State p -> State (f p)
  | Temporal_not g -> Temporal_not (states f g)
  | Temporal_and gs -> Temporal_and (List.map (states f) gs)
  | Temporal_or gs -> Temporal_or (List.map (states f) gs)
  | Next (q, g) -> Next (q, states f g)
  | Finally (q, b, g) -> Finally (q, b, states f g)
  | Globally (q, b, g) -> Globally (q, b, states f g)
  | Until (q, b, g, h) -> Until (q, b, states f g, states f h)

let temporal f g = states (prop f) g

let mean f = function
  | Time_until g -> Time_until (temporal f g)
  | Events_until (e, g) -> Events_until (prop f e, temporal f g)
  | Value_at (n, time) -> Value_at (num f n, time)

let check f (c : check) =
  let asked =
    match c.asked with
    | (Whether | How_likely _) as asked -> asked
    | Expected (sides, m, test) -> Expected (sides, mean f m, test)
  in
  { c with asked; formula = temporal f c.formula }

(* {1 Values of parameters} *)

let rec known_num values n =
  let num = known_num values in
  match n with
  | Quantity (Parameter i) -> Const values.(i)
  | Const _ | Quantity _ -> n
  | Count ps -> Count (List.map (known values) ps)
  | Neg a -> Neg (num a)
  | Add (a, b) -> Add (num a, num b)
  | Sub (a, b) -> Sub (num a, num b)
  | Mul (a, b) -> Mul (num a, num b)
  | Div (a, b) -> Div (num a, num b)
  | If (p, a, b) -> If (known values p, num a, num b)

and known values = function
  | (Bool _ | Fact _) as p -> p
  | Compare (c, a, b) -> Compare (c, known_num values a, known_num values b)
  | Not p -> Not (known values p)
  | And ps -> And (List.map (known values) ps)
  | Or ps -> Or (List.map (known values) ps)

let known_temporal values = states (known values)

(* {1 One form of formulas that differ in order alone} *)

(* The renaming that puts the two leaves of a symmetric atom in order. *)
let in_order (atom : Atom.t) =
  match Atom.leaves atom with
  | [ i; j ] when atom.symmetric && j < i -> fun k -> if k = i then j else i
  | _ -> Fun.id

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

let summands = flatten (function Add (a, b) -> Some [ a; b ] | _ -> None)
let factors = flatten (function Mul (a, b) -> Some [ a; b ] | _ -> None)
let conjuncts = function And ps -> Some ps | _ -> None
let disjuncts = function Or ps -> Some ps | _ -> None
let temporal_conjuncts = function Temporal_and fs -> Some fs | _ -> None
let temporal_disjuncts = function Temporal_or fs -> Some fs | _ -> None

let rebuild make = function
  | [] -> Bug.fail __POS__ "an operator without operands"
  | x :: rest -> List.fold_left make x rest

let rec ordered_num n =
  match n with
  | Const _ -> n
  | Quantity q -> Quantity (Atom.renamed_quantity (in_order (Atom.quantity q)) q)
  | Count ps -> Count (sorted_props ps)
  | Neg a -> Neg (ordered_num a)
  | Add _ -> rebuild (fun a b -> Add (a, b)) (sorted_nums (summands n))
  | Mul _ -> rebuild (fun a b -> Mul (a, b)) (sorted_nums (factors n))
  | Sub (a, b) -> Sub (ordered_num a, ordered_num b)
  | Div (a, b) -> Div (ordered_num a, ordered_num b)
  | If (p, a, b) -> If (ordered_prop p, ordered_num a, ordered_num b)

and sorted_nums ns = List.sort Order.num (List.map ordered_num ns)
and sorted_props ps = List.sort Order.prop (List.map ordered_prop ps)

and ordered_prop p =
  match p with
  | Bool _ -> p
  | Compare (Gt, a, b) -> Compare (Lt, ordered_num b, ordered_num a)
  | Compare (Ge, a, b) -> Compare (Le, ordered_num b, ordered_num a)
  | Compare (((Lt | Le) as c), a, b) -> Compare (c, ordered_num a, ordered_num b)
  | Compare (((Eq | Ne) as c), a, b) ->
    let a = ordered_num a and b = ordered_num b in
    if Order.num a b <= 0 then Compare (c, a, b) else Compare (c, b, a)
  | Fact x -> Fact (Atom.renamed_fact (in_order (Atom.fact x)) x)
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

and sorted fs = List.sort Order.temporal (List.map ordered fs)
