open Scc_exact
open Scc_calculus
open Property

type t = Never | Until of Rat.t | Always

let join a b =
  match (a, b) with
  | Always, _ | _, Always -> Always
  | Never, x | x, Never -> x
  | Until s, Until t -> Until (Rat.max s t)

let join_all f list = List.fold_left (fun seen x -> join seen (f x)) Never list

let of_time : quantity -> Vec.t option = function
  | Time -> Some (Vec.of_ints 1 0 0)
  | Bonds _ | Size _ | Processes | Position _ | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Distance2 _ | Momentum _
  | Angular _ | Energy | Parameter _ -> None

(* After this the number has one sign. *)
let settles c =
  match By_cases.zeros c with
  | None -> Never
  | Some (_, (_, last)) -> Until (Rat.max Rat.zero last)

let atom a = if Atom.depends_on Absolute_time a then Always else Never

let rec num m = function
  | Quantity q -> atom (Atom.quantity q)
  | n ->
    let { Parts.numbers; predicates } = Parts.of_num n in
    join (join_all (prop m) predicates) (join_all (num m) numbers)

and prop m = function
  | Compare (_, a, b) -> (
      match By_cases.cases m ~variable:of_time (Sub (a, b)) with
      | Some cases -> join (join_all settles cases) (join (conditions m a) (conditions m b))
      | None -> join (num m a) (num m b))
  | Fact f -> atom (Atom.fact f)
  | p -> join_all (prop m) (Parts.of_prop p).predicates

(* What conditions within a number see. *)
and conditions m n = join_all (prop m) (By_cases.conditions n)

let formula m f = join_all (prop m) (Formula.predicates f)

(* The formula of a mean at a time compares it with 0; but all of it is asked for. *)
let check m (c : Property.check) =
  let value =
    match c.asked with
    | Expected (_, Value_at (n, _), _) -> num m n
    | Expected (_, (Time_until _ | Events_until _), _) | Whether | How_likely _ -> Never
  in
  join value (formula m c.formula)

let checks m list = join_all (check m) list

(* {1 Laws} *)

(* Of a number only matters where the time is in it: whatever else a law looks at is something that changes. *)
let rec of_expr : Law.expr -> num = function
  | Const b -> Const b
  | Open n -> Const n.value
  | Var Time -> Quantity Time
  | Var (X | Y | Z | Vx | Vy | Vz | Wx | Wy | Wz | Mass | Dt) -> Quantity Energy
  | Neg a -> Neg (of_expr a)
  | Add (a, b) -> Add (of_expr a, of_expr b)
  | Sub (a, b) -> Sub (of_expr a, of_expr b)
  | Mul (a, b) -> Mul (of_expr a, of_expr b)
  | Div (a, b) -> Div (of_expr a, of_expr b)
  | Round (a, b) -> Mul (Quantity Energy, Add (of_expr a, of_expr b))
  | If (c, a, b) -> If (of_cond c, of_expr a, of_expr b)

and of_cond : Law.cond -> prop = function
  | Bool b -> Bool b
  | Compare (c, a, b) -> Compare (c, of_expr a, of_expr b)
  | And (c, d) -> And [ of_cond c; of_cond d ]
  | Or (c, d) -> Or [ of_cond c; of_cond d ]
  | Not c -> Not (of_cond c)

let law m (law : Law.t) =
  let expr e = num m (of_expr e) in
  let vector (x, y, z) = join_all expr [ x; y; z ] in
  let motion (m : Law.motion) = join (vector m.velocity) (Option.fold ~none:Never ~some:vector m.spin) in
  match law with
  | Inertial -> Never
  | Gives m -> motion m
  | Choose kicks -> join_all (fun (k : Law.kick) -> join (motion k.motion) (expr k.weight)) kicks

let same_kind a b =
  match (a, b) with
  | Never, Never | Until _, Until _ | Always, Always -> true
  | (Never | Until _ | Always), _ -> false

let beyond seen time =
  match seen with
  | Until c when Rat.compare time c > 0 -> Some c
  | Never | Until _ | Always -> None

let representative seen time =
  match (seen, beyond seen time) with
  | Never, _ -> Rat.zero
  | (Until _ | Always), Some c -> Rat.add c Rat.one
  | (Until _ | Always), None -> time
