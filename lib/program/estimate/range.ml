open Scc_exact
open Scc_calculus
open Scc_property

type t = { low : Rat.t; high : Rat.t; ends_only : bool }

let is_point r = Rat.equal r.low r.high
let point x = { low = x; high = x; ends_only = true }
let from_to low high = { low = Rat.of_int low; high = Rat.of_int high; ends_only = high - low <= 1 }

(* The least range that has all of them. *)
let around ~ends_only = function
  | [] -> None
  | x :: xs ->
    let low, high = Rat.span x xs in
    Some { low; high; ends_only }

let combined f a b =
  around
    ~ends_only:(a.ends_only && b.ends_only && (is_point a || is_point b))
    [ f a.low b.low; f a.low b.high; f a.high b.low; f a.high b.high ]

let either a b =
  let*? all = around ~ends_only:false [ a.low; a.high; b.low; b.high ] in
  let at_an_end x = Rat.equal x all.low || Rat.equal x all.high in
  let ends r = r.ends_only && at_an_end r.low && at_an_end r.high in
  Some { all with ends_only = ends a && ends b }

(* Bonds make trees, or two leaves have one bond at most (Def-5.2, I-37); and each leaf is in one process or in
   none (WellFormed). *)
let of_quantity (m : Model.t) ~time : Property.quantity -> t option =
  let leaves = Array.length m.leaves in
  function
  | Bonds (_, None) ->
    Some (from_to 0 (match m.bonds with Acyclic -> Int.max 0 (leaves - 1) | Cyclic -> leaves * (leaves - 1) / 2))
  | Bonds (_, Some _) -> Some (from_to 0 1)
  | Size _ -> Some (from_to 0 (Array.fold_left (fun n (l : Model.leaf) -> n + Array.length l.parts) 0 m.leaves))
  | Processes -> Some (from_to 0 leaves)
  | Time -> Some (point time)
  | Position _ | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Distance2 _ | Momentum _ | Angular _ | Energy
  | Parameter _ -> None

let rec of_number m ~time (n : Property.num) =
  let both f a b =
    let*? a = of_number m ~time a in
    let*? b = of_number m ~time b in
    f a b
  in
  match n with
  | Const c -> Some (point c)
  | Quantity q -> of_quantity m ~time q
  | Count props -> Some (from_to 0 (List.length props))
  | Neg a -> both (combined Rat.sub) (Const Rat.zero) a
  | Add (a, b) -> both (combined Rat.add) a b
  | Sub (a, b) -> both (combined Rat.sub) a b
  | Mul (a, b) -> both (combined Rat.mul) a b
  | Div (a, b) ->
    let quotient a b =
      if Rat.sign b.low * Rat.sign b.high > 0 then combined Rat.div a b else None
    in
    both quotient a b
  | If (_, a, b) -> both either a b
