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

(* A number that is, in each of some cases, [rate] times the time and something from [least] to [greatest]. *)
type case = { rate : Rat.t; least : Rat.t; greatest : Rat.t }

(* More cases than this are not told apart. *)
let most_cases = 64

let constant b = { rate = Rat.zero; least = b; greatest = b }
let ranges greatest = Some [ { rate = Rat.zero; least = Rat.zero; greatest = Rat.of_int greatest } ]

let scaled k c =
  let ends = (Rat.mul k c.least, Rat.mul k c.greatest) in
  let least, greatest = if Rat.sign k < 0 then (snd ends, fst ends) else ends in
  { rate = Rat.mul k c.rate; least; greatest }

let sum c d =
  { rate = Rat.add c.rate d.rate; least = Rat.add c.least d.least; greatest = Rat.add c.greatest d.greatest }

(* The one number that it is in all cases, if so. *)
let single = function
  | [ c ] when Rat.sign c.rate = 0 && Rat.equal c.least c.greatest -> Some c.least
  | _ -> None

let few cases = if List.compare_length_with cases most_cases > 0 then None else Some cases

(* How many bonds, leaves and processes there may be. *)
let quantity (m : Model.t) (q : quantity) =
  match q with
  | Time -> Some [ { (constant Rat.zero) with rate = Rat.one } ]
  | Processes -> ranges (Array.length m.leaves)
  | Size _ -> ranges (Model.part_count m)
  | Bonds (_, Some _) -> ranges 1
  | Bonds (_, None) ->
    let n = Array.length m.leaves in
    ranges (n * (n - 1) / 2)
  | Position _ | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Distance2 _ | Momentum _ | Angular _ | Energy
  | Parameter _ -> None

let rec cases m = function
  | Const b -> Some [ constant b ]
  | Quantity q -> quantity m q
  | Count ps -> ranges (List.length ps)
  | Neg n -> Option.map (List.map (scaled (Rat.neg Rat.one))) (cases m n)
  | Add (a, b) -> both m (fun xs ys -> few (List.concat_map (fun x -> List.map (sum x) ys) xs)) a b
  | Sub (a, b) -> cases m (Add (a, Neg b))
  | Mul (a, b) ->
    let product xs ys =
      match (single xs, single ys) with
      | Some k, _ -> Some (List.map (scaled k) ys)
      | None, Some k -> Some (List.map (scaled k) xs)
      | None, None -> None
    in
    both m product a b
  | Div (a, b) ->
    let quotient xs ys =
      match single ys with
      | Some k when Rat.sign k <> 0 -> Some (List.map (scaled (Rat.div Rat.one k)) xs)
      | Some _ | None -> None
    in
    both m quotient a b
  | If (_, a, b) -> both m (fun xs ys -> few (xs @ ys)) a b

and both m f a b =
  match (cases m a, cases m b) with
  | Some xs, Some ys -> f xs ys
  | None, _ | _, None -> None

(* After this the number has one sign. *)
let settles c =
  if Rat.sign c.rate = 0 then Never
  else
    let last = Rat.max (Rat.div (Rat.neg c.least) c.rate) (Rat.div (Rat.neg c.greatest) c.rate) in
    Until (Rat.max Rat.zero last)

let atom a = if Atom.depends_on Absolute_time a then Always else Never

let rec num m = function
  | Const _ -> Never
  | Quantity q -> atom (Atom.quantity q)
  | Count ps -> join_all (prop m) ps
  | Neg n -> num m n
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) -> join (num m a) (num m b)
  | If (p, a, b) -> join (prop m p) (join (num m a) (num m b))

and prop m = function
  | Compare (_, a, b) -> (
      match cases m (Sub (a, b)) with
      | Some cases -> join (join_all settles cases) (join (conditions m a) (conditions m b))
      | None -> join (num m a) (num m b))
  | Not p -> prop m p
  | And ps | Or ps -> join_all (prop m) ps
  | Fact f -> atom (Atom.fact f)
  | Bool _ -> Never

(* What conditions within a number see. *)
and conditions m = function
  | Const _ | Quantity _ -> Never
  | Count ps -> join_all (prop m) ps
  | Neg n -> conditions m n
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) -> join (conditions m a) (conditions m b)
  | If (p, a, b) -> join (prop m p) (join (conditions m a) (conditions m b))

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
  | Var Time -> Quantity Time
  | Var (X | Y | Z | Vx | Vy | Vz | Mass | Dt) -> Quantity Energy
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
  match law with
  | Inertial -> Never
  | Velocity v -> vector v
  | Choose kicks -> join_all (fun (k : Law.kick) -> join (vector k.velocity) (expr k.weight)) kicks

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
  | _, Some c -> Rat.add c Rat.one
  | (Until _ | Always), None -> time
