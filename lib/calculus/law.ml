open Scc_exact

type variable = X | Y | Z | Vx | Vy | Vz | Mass | Time | Dt
type comparison = Lt | Le | Gt | Ge | Eq | Ne

type expr =
  | Const of Rat.t
  | Var of variable
  | Neg of expr
  | Add of expr * expr
  | Sub of expr * expr
  | Mul of expr * expr
  | Div of expr * expr
  | Round of expr * expr
  | If of cond * expr * expr

and cond =
  | Bool of bool
  | Compare of comparison * expr * expr
  | And of cond * cond
  | Or of cond * cond
  | Not of cond

type t = Inertial | Velocity of expr * expr * expr
type fault = Division_by_zero | Bad_quantum

let compare_rationals comparison a b =
  let c = Rat.compare a b in
  match comparison with
  | Lt -> c < 0
  | Le -> c <= 0
  | Gt -> c > 0
  | Ge -> c >= 0
  | Eq -> c = 0
  | Ne -> c <> 0

let ( let* ) = Result.bind

let rec eval env = function
  | Const k -> Ok k
  | Var v -> Ok (env v)
  | Neg a -> Result.map Rat.neg (eval env a)
  | Add (a, b) -> both env Rat.add a b
  | Sub (a, b) -> both env Rat.sub a b
  | Mul (a, b) -> both env Rat.mul a b
  | Div (a, b) ->
    let* a = eval env a in
    let* b = eval env b in
    if Rat.sign b = 0 then Error Division_by_zero else Ok (Rat.div a b)
  | Round (a, q) ->
    let* a = eval env a in
    let* quantum = eval env q in
    if Rat.sign quantum <= 0 then Error Bad_quantum else Ok (Rat.round_to a ~quantum)
  | If (c, a, b) ->
    let* c = holds env c in
    eval env (if c then a else b)

and both env f a b =
  let* a = eval env a in
  let* b = eval env b in
  Ok (f a b)

and holds env = function
  | Bool b -> Ok b
  | Compare (c, a, b) ->
    let* a = eval env a in
    let* b = eval env b in
    Ok (compare_rationals c a b)
  | Not c -> Result.map not (holds env c)
  | And (a, b) ->
    let* a = holds env a in
    if a then holds env b else Ok false
  | Or (a, b) ->
    let* a = holds env a in
    if a then Ok true else holds env b

let rec expr_mentions = function
  | Const _ -> false
  | Var v -> ( match v with Time -> true | X | Y | Z | Vx | Vy | Vz | Mass | Dt -> false)
  | Neg a -> expr_mentions a
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) | Round (a, b) ->
    expr_mentions a || expr_mentions b
  | If (c, a, b) -> cond_mentions c || expr_mentions a || expr_mentions b

and cond_mentions = function
  | Bool _ -> false
  | Compare (_, a, b) -> expr_mentions a || expr_mentions b
  | And (a, b) | Or (a, b) -> cond_mentions a || cond_mentions b
  | Not c -> cond_mentions c

let mentions_time = function
  | Inertial -> false
  | Velocity (a, b, c) -> expr_mentions a || expr_mentions b || expr_mentions c
