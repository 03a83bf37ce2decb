open Scc_exact

type side = Least | Greatest
type chance = { side : side; test : Scc_chance.Answer.bound }
type quantifier = All | Exists | Chance of chance
type bound = { low : Rat.t; high : Rat.t option }

type t =
  | Predicate of int
  | Not of t
  | And of t list
  | Or of t list
  | Next of quantifier * t
  | Until of quantifier * bound * t * t
  | Finally of quantifier * bound * t
  | Globally of quantifier * bound * t

let compare_chance a b =
  compare a.side b.side <?> fun () -> Scc_chance.Answer.compare_bound a.test b.test

let quantifier_rank = function All -> 0 | Exists -> 1 | Chance _ -> 2

let compare_quantifier a b =
  match (a, b) with
  | Chance c, Chance d -> compare_chance c d
  | (All | Exists | Chance _), _ -> Int.compare (quantifier_rank a) (quantifier_rank b)

let other_side = function Least -> Greatest | Greatest -> Least

(* "At least p of all runs satisfy f": for the most of them that can, not more than 1 - p do not satisfy it. *)
let dual = function
  | All -> Exists
  | Exists -> All
  | Chance { side; test } ->
    let relation : Scc_chance.Answer.relation =
      match test.relation with
      | Less -> At_most
      | At_most -> Less
      | At_least_so -> More
      | More -> At_least_so
    in
    Chance { side = other_side side; test = { relation; than = Rat.sub Rat.one test.than } }

let compare_bound a b = Rat.compare a.low b.low <?> fun () -> Option.compare Rat.compare a.high b.high

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
  | Next (p, f), Next (q, g) -> compare_quantifier p q <?> fun () -> compare f g
  | Until (p, b, f, g), Until (q, c, h, i) ->
    compare_quantifier p q <?> fun () -> compare_bound b c <?> fun () -> compare f h <?> fun () -> compare g i
  | Finally (p, b, f), Finally (q, c, g) | Globally (p, b, f), Globally (q, c, g) ->
    compare_quantifier p q <?> fun () -> compare_bound b c <?> fun () -> compare f g
  | ( ( Predicate _ | Not _ | And _ | Or _ | Next _ | Until _ | Finally _ | Globally _ ), _ ) ->
    Int.compare (rank a) (rank b)

(** {2 For messages} *)

let chance { side; test } =
  let p = match side with Least -> "Pmin" | Greatest -> "Pmax" in
  Printf.sprintf "%s %s" p (Scc_chance.Answer.bound_to_string test)

let letter = function All -> "A" | Exists -> "E" | Chance c -> chance c ^ " "

let bound b =
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
