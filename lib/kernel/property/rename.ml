open Scc_base
open Property

let rec num f = function
  | Quantity q -> Quantity (Atom.renamed_quantity f q)
  | n -> Parts.map_num ~num:(num f) ~prop:(prop f) n

and prop f = function
  | Fact x -> Fact (Atom.renamed_fact f x)
  | p -> Parts.map_prop ~num:(num f) ~prop:(prop f) p

(* A temporal formula with its predicates mapped. *)
let rec states f = function
  | State p -> State (f p)
  | g -> Parts.map_temporal (states f) g

let temporal f g = states (prop f) g

(* {1 Values of parameters} *)

let rec known_num values = function
  | Quantity (Parameter i) -> Const values.(i)
  | n -> Parts.map_num ~num:(known_num values) ~prop:(known values) n

and known values p = Parts.map_prop ~num:(known_num values) ~prop:(known values) p

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
  | Quantity q -> Quantity (Atom.renamed_quantity (in_order (Atom.quantity q)) q)
  | Count ps -> Count (sorted_props ps)
  | Add _ -> rebuild (fun a b -> Add (a, b)) (sorted_nums (summands n))
  | Mul _ -> rebuild (fun a b -> Mul (a, b)) (sorted_nums (factors n))
  | _ -> Parts.map_num ~num:ordered_num ~prop:ordered_prop n

and sorted_nums ns = List.sort Order.num (List.map ordered_num ns)
and sorted_props ps = List.sort Order.prop (List.map ordered_prop ps)

and ordered_prop p =
  match p with
  | Compare (Gt, a, b) -> Compare (Lt, ordered_num b, ordered_num a)
  | Compare (Ge, a, b) -> Compare (Le, ordered_num b, ordered_num a)
  | Compare (((Eq | Ne) as c), a, b) ->
    let a = ordered_num a and b = ordered_num b in
    if Order.num a b <= 0 then Compare (c, a, b) else Compare (c, b, a)
  | Fact x -> Fact (Atom.renamed_fact (in_order (Atom.fact x)) x)
  | And _ -> And (sorted_props (flatten conjuncts p))
  | Or _ -> Or (sorted_props (flatten disjuncts p))
  | _ -> Parts.map_prop ~num:ordered_num ~prop:ordered_prop p

let rec ordered f =
  match f with
  | State p -> State (ordered_prop p)
  | Temporal_and _ -> Temporal_and (sorted (flatten temporal_conjuncts f))
  | Temporal_or _ -> Temporal_or (sorted (flatten temporal_disjuncts f))
  | _ -> Parts.map_temporal ordered f

and sorted fs = List.sort Order.temporal (List.map ordered fs)
