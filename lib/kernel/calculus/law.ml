open Scc_exact

type variable = X | Y | Z | Vx | Vy | Vz | Wx | Wy | Wz | Mass | Time | Dt
type comparison = Lt | Le | Gt | Ge | Eq | Ne

type expr =
  | Const of Rat.t
  | Open of Open_number.t
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

type vector = expr * expr * expr
type motion = { velocity : vector; spin : vector option }
type kick = { motion : motion; weight : expr }
type t = Inertial | Gives of motion | Choose of kick list
let velocity_alone velocity = { velocity; spin = None }

type fault = Division_by_zero | Bad_quantum | Too_long | Negative_weight | No_weight | Too_many

let longest = 1 lsl 24
let most_outcomes = 1_000_000

let by_sign comparison c =
  match comparison with
  | Lt -> c < 0
  | Le -> c <= 0
  | Gt -> c > 0
  | Ge -> c >= 0
  | Eq -> c = 0
  | Ne -> c <> 0

let compare_rationals comparison a b = by_sign comparison (Rat.compare a b)

(* Neither a sum nor a product takes more bits than both together, and a carry. *)
let both_known f a b = if Rat.bits a + Rat.bits b > longest then Error Too_long else Ok (f a b)

let rec eval env = function
  | Const k -> Ok k
  | Open n -> Ok n.value
  | Var v -> Ok (env v)
  | Neg a -> Result.map Rat.neg (eval env a)
  | Add (a, b) -> both env Rat.add a b
  | Sub (a, b) -> both env Rat.sub a b
  | Mul (a, b) -> both env Rat.mul a b
  | Div (a, b) ->
    let* a = eval env a in
    let* b = eval env b in
    if Rat.sign b = 0 then Error Division_by_zero else both_known Rat.div a b
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
  both_known f a b

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

let rec form ~divisor env e =
  let both f a b =
    let* a = form ~divisor env a in
    Result.map (f a) (form ~divisor env b)
  in
  match e with
  | Open n -> Ok n.form
  | Const _ | Var _ | Round _ -> Result.map Rational_function.constant (eval env e)
  | Neg a -> Result.map Rational_function.neg (form ~divisor env a)
  | Add (a, b) -> both Rational_function.add a b
  | Sub (a, b) -> both Rational_function.sub a b
  | Mul (a, b) -> both Rational_function.mul a b
  | Div (a, b) ->
    let* a = form ~divisor env a in
    let* b = form ~divisor env b in
    if divisor b then Ok (Rational_function.div a b) else Error Division_by_zero
  | If (c, a, b) ->
    let* c = holds env c in
    form ~divisor env (if c then a else b)

let rec is_open = function
  | Open _ -> true
  | Const _ | Var _ -> false
  | Neg a -> is_open a
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) | Round (a, b) -> is_open a || is_open b
  | If (c, a, b) -> is_open_cond c || is_open a || is_open b

and is_open_cond = function
  | Bool _ -> false
  | Compare (_, a, b) -> is_open a || is_open b
  | And (a, b) | Or (a, b) -> is_open_cond a || is_open_cond b
  | Not c -> is_open_cond c

let rec misused = function
  | Open _ | Const _ | Var _ -> false
  | Neg a -> misused a
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) -> misused a || misused b
  | Round (a, b) -> is_open a || is_open b
  | If (c, a, b) -> is_open_cond c || misused a || misused b

let rec expr_mentions test = function
  | Const _ | Open _ -> false
  | Var v -> test v
  | Neg a -> expr_mentions test a
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) | Round (a, b) ->
    expr_mentions test a || expr_mentions test b
  | If (c, a, b) -> cond_mentions test c || expr_mentions test a || expr_mentions test b

and cond_mentions test = function
  | Bool _ -> false
  | Compare (_, a, b) -> expr_mentions test a || expr_mentions test b
  | And (a, b) | Or (a, b) -> cond_mentions test a || cond_mentions test b
  | Not c -> cond_mentions test c

let vector_mentions test (a, b, c) = expr_mentions test a || expr_mentions test b || expr_mentions test c

let motion_mentions test { velocity; spin } =
  vector_mentions test velocity || Option.fold ~none:false ~some:(vector_mentions test) spin

let mentions test = function
  | Inertial -> false
  | Gives motion -> motion_mentions test motion
  | Choose kicks -> List.exists (fun k -> motion_mentions test k.motion || expr_mentions test k.weight) kicks

let is_constant law = not (mentions (fun _ -> true) law)

(* No variable is looked up where there is none. *)
let never_fails law =
  let value = eval (fun _ -> Rat.zero) in
  let has_value e = Result.is_ok (value e) in
  let has_values (x, y, z) = has_value x && has_value y && has_value z in
  let has_motion { velocity; spin } = has_values velocity && Option.fold ~none:true ~some:has_values spin in
  let weight k = match value k.weight with Ok w -> Rat.sign w | Error _ -> -1 in
  let fits k = match weight k with 0 -> true | sign -> sign > 0 && has_motion k.motion in
  is_constant law
  &&
  match law with
  | Inertial -> true
  | Gives motion -> has_motion motion
  | Choose kicks -> List.for_all fits kicks && List.exists (fun k -> weight k > 0) kicks

let mentions_time =
  mentions (function
      | Time -> true
      | X | Y | Z | Vx | Vy | Vz | Wx | Wy | Wz | Mass | Dt -> false)

let mentions_position =
  mentions (function
      | X | Y | Z -> true
      | Vx | Vy | Vz | Wx | Wy | Wz | Mass | Time | Dt -> false)

let rec equal_expr a b =
  match (a, b) with
  | Const x, Const y -> Rat.equal x y
  | Open m, Open n -> Rational_function.equal m.form n.form
  | Var v, Var w -> v = w
  | Neg a, Neg b -> equal_expr a b
  | Add (a, b), Add (c, d)
  | Sub (a, b), Sub (c, d)
  | Mul (a, b), Mul (c, d)
  | Div (a, b), Div (c, d)
  | Round (a, b), Round (c, d) -> equal_expr a c && equal_expr b d
  | If (c, a, b), If (d, x, y) -> equal_cond c d && equal_expr a x && equal_expr b y
  | (Const _ | Open _ | Var _ | Neg _ | Add _ | Sub _ | Mul _ | Div _ | Round _ | If _), _ -> false

and equal_cond a b =
  match (a, b) with
  | Bool x, Bool y -> Bool.equal x y
  | Compare (o, a, b), Compare (p, c, d) -> o = p && equal_expr a c && equal_expr b d
  | And (a, b), And (c, d) | Or (a, b), Or (c, d) -> equal_cond a c && equal_cond b d
  | Not a, Not b -> equal_cond a b
  | (Bool _ | Compare _ | And _ | Or _ | Not _), _ -> false

let equal_vector (a, b, c) (d, e, f) = equal_expr a d && equal_expr b e && equal_expr c f
let equal_motion a b = equal_vector a.velocity b.velocity && Option.equal equal_vector a.spin b.spin
let equal_kick a b = equal_motion a.motion b.motion && equal_expr a.weight b.weight

let equal a b =
  match (a, b) with
  | Inertial, Inertial -> true
  | Gives a, Gives b -> equal_motion a b
  | Choose kicks, Choose others -> List.equal equal_kick kicks others
  | (Inertial | Gives _ | Choose _), _ -> false

let is_inertial = function
  | Inertial -> true
  | Gives _ | Choose _ -> false

let draws = function
  | Choose _ -> true
  | Inertial | Gives _ -> false

let gives_spin =
  let spins motion = Option.is_some motion.spin in
  function
  | Inertial -> false
  | Gives motion -> spins motion
  | Choose kicks -> List.exists (fun k -> spins k.motion) kicks
