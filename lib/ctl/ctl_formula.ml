open Scc_exact
open Scc_property

type t =
  | Predicate of int
  | Not of t
  | And of t list
  | Or of t list
  | Next of Property.path_quantifier * t
  | Until of Property.path_quantifier * Property.bound * t * t
  | Finally of Property.path_quantifier * Property.bound * t
  | Globally of Property.path_quantifier * Property.bound * t

let first_difference list = match List.find_opt (fun c -> c <> 0) list with Some c -> c | None -> 0

let rank = function
  | Predicate _ -> 0
  | Not _ -> 1
  | And _ -> 2
  | Or _ -> 3
  | Next _ -> 4
  | Until _ -> 5
  | Finally _ -> 6
  | Globally _ -> 7

let rec compare a b =
  match (a, b) with
  | Predicate i, Predicate j -> Int.compare i j
  | Not f, Not g -> compare f g
  | And l, And m | Or l, Or m -> List.compare compare l m
  | Next (p, f), Next (q, g) -> first_difference [ Order.quantifier p q; compare f g ]
  | Until (p, b, f, g), Until (q, c, h, i) ->
    first_difference [ Order.quantifier p q; Order.bound b c; compare f h; compare g i ]
  | Finally (p, b, f), Finally (q, c, g) | Globally (p, b, f), Globally (q, c, g) ->
    first_difference [ Order.quantifier p q; Order.bound b c; compare f g ]
  | ( ( Predicate _ | Not _ | And _ | Or _ | Next _ | Until _ | Finally _ | Globally _ ), _ ) ->
    Int.compare (rank a) (rank b)

(** {2 From properties} *)

let of_temporal formulas =
  let found = ref [] and count = ref 0 in
  let number p =
    match List.find_opt (fun (q, _) -> Formula.equal_prop p q) !found with
    | Some (_, k) -> k
    | None ->
      let k = !count in
      found := (p, k) :: !found;
      incr count;
      k
  in
  let rec go (f : Property.temporal) =
    match f with
    | State p -> Predicate (number p)
    | Temporal_not f -> Not (go f)
    | Temporal_and l -> And (List.map go l)
    | Temporal_or l -> Or (List.map go l)
    | Next (q, f) -> Next (q, go f)
    | Finally (q, b, f) -> Finally (q, b, go f)
    | Globally (q, b, f) -> Globally (q, b, go f)
    | Until (q, b, f, g) ->
      let f = go f in
      Until (q, b, f, go g)
  in
  let formulas = List.map go formulas in
  (formulas, Array.of_list (List.rev_map fst !found))

let rec to_temporal prop f =
  let go = to_temporal prop in
  match f with
  | Predicate k -> Property.State (prop k)
  | Not f -> Temporal_not (go f)
  | And fs -> Temporal_and (Scc_base.Long_list.map go fs)
  | Or fs -> Temporal_or (Scc_base.Long_list.map go fs)
  | Next (q, f) -> Next (q, go f)
  | Finally (q, b, f) -> Finally (q, b, go f)
  | Globally (q, b, f) -> Globally (q, b, go f)
  | Until (q, b, f, g) -> Until (q, b, go f, go g)

(** {2 For messages} *)

let letter : Property.path_quantifier -> string = function All -> "A" | Exists -> "E"

let bound (b : Property.bound) =
  match b.high with
  | None -> if Rat.sign b.low = 0 then "" else Printf.sprintf "[%s, inf)" (Rat.to_string b.low)
  | Some h -> Printf.sprintf "[%s, %s]" (Rat.to_string b.low) (Rat.to_string h)

let rec to_string name f =
  let list op l = "(" ^ String.concat op (List.map (to_string name) l) ^ ")" in
  let unary op q b f = Printf.sprintf "%s%s%s %s" (letter q) op b (to_string name f) in
  match f with
  | Predicate p -> name p
  | Not f -> "!" ^ to_string name f
  | And [] -> "true"
  | Or [] -> "false"
  | And l -> list " & " l
  | Or l -> list " | " l
  | Next (q, f) -> unary "X" q "" f
  | Finally (q, b, f) -> unary "F" q (bound b) f
  | Globally (q, b, f) -> unary "G" q (bound b) f
  | Until (q, b, f, g) ->
    Printf.sprintf "%s(%s U%s %s)" (letter q) (to_string name f) (bound b) (to_string name g)
