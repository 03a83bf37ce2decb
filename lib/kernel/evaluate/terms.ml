open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property

module type View = sig
  type context
  type t
  type number
  type truth

  val semantics : context -> Semantics.t
  val quantity : context -> Meaning.quantity -> t -> number
  val fact : context -> Meaning.fact -> t -> truth
  val constant : Rat.t -> t -> number
  val neg : number -> number
  val add : number -> number -> number
  val sub : number -> number -> number
  val mul : number -> number -> number
  val div : reason:string -> number -> number -> number
  val choose : truth -> (unit -> number) -> (unit -> number) -> number
  val count : number -> truth -> number
  val bool : bool -> t -> truth
  val compare : Law.comparison -> number -> number -> truth
  val not_ : truth -> truth
  val and_ : truth -> truth -> truth
  val is_false : truth -> bool
end

let few = 16

module Make (V : View) = struct
  let rec num c (n : Property.num) : V.t -> V.number =
    match n with
    | Const r -> V.constant r
    | Quantity q -> V.quantity c (Meaning.quantity (Semantics.model (V.semantics c)) q)
    | Neg a ->
      let a = num c a in
      fun v -> V.neg (a v)
    | Add (a, b) -> both V.add c a b
    | Sub (a, b) -> both V.sub c a b
    | Mul (a, b) -> both V.mul c a b
    | Div (a, b) ->
      let reason = "division by zero in " ^ Show.num (Semantics.model (V.semantics c)) n in
      both (V.div ~reason) c a b
    | If (p, a, b) ->
      let p = prop c p and a = num c a and b = num c b in
      fun v -> V.choose (p v) (fun () -> a v) (fun () -> b v)
    | Count props ->
      let props = Array.of_list (List.map (prop c) props) in
      fun v -> counted v props ~from:0 ~until:(Array.length props)

  and both f c a b =
    let a = num c a and b = num c b in
    fun v -> f (a v) (b v)

  (* Many in halves: a number over time has as many pieces as there are instants at which what is counted changes,
     and to count one more goes through all of them. *)
  and counted v props ~from ~until =
    if until - from <= few then
      List.init (until - from) (fun k -> props.(from + k))
      |> List.fold_left (fun n p -> V.count n (p v)) (V.constant Rat.zero v)
    else
      let middle = (from + until) / 2 in
      let first = counted v props ~from ~until:middle in
      V.add first (counted v props ~from:middle ~until)

  and prop c (p : Property.prop) : V.t -> V.truth =
    match p with
    | Bool b -> V.bool b
    | Compare (op, a, b) ->
      let a = num c a and b = num c b in
      fun v -> V.compare op (a v) (b v)
    | Fact f -> V.fact c (Meaning.fact (V.semantics c) f)
    | Not p ->
      let p = prop c p in
      fun v -> V.not_ (p v)
    | And ps -> conjunction (List.map (prop c) ps)
    | Or ps ->
      let negated = conjunction (List.map (fun p -> let p = prop c p in fun v -> V.not_ (p v)) ps) in
      fun v -> V.not_ (negated v)

  and conjunction ps v =
    let rec go found = function
      | [] -> found
      | p :: later -> if V.is_false found then found else go (V.and_ found (p v)) later
    in
    go (V.bool true v) ps
end
