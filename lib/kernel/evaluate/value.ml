open Scc_ctl
open Scc_exact
open Scc_calculus

type t = Ratio of Polynomial.t * Polynomial.t | Undefined of string

let equal a b =
  match (a, b) with
  | Ratio (n, d), Ratio (m, e) -> Polynomial.equal n m && Polynomial.equal d e
  | Undefined r, Undefined s -> String.equal r s
  | Ratio _, Undefined _ | Undefined _, Ratio _ -> false

let polynomial p = Ratio (p, Polynomial.one)
let of_rat r = polynomial (Polynomial.constant r)
let of_int n = of_rat (Rat.of_int n)
let not_followed = "what turns with a body that spins for ever is not followed"

let of_curve : Scc_motion.Path.curve -> t = function
  | Steady r -> of_rat r
  | Quotient (n, d) -> Ratio (n, d)
  | Not_followed -> Undefined not_followed

let lift f a b =
  match (a, b) with
  | Undefined r, _ | _, Undefined r -> Undefined r
  | Ratio (n, d), Ratio (m, e) -> f (n, d) (m, e)

(* Of a numerator or a denominator: finding the roots of polynomials of greater degrees could take hours. *)
let greatest_degree = 200

let too_high =
  Undefined (Printf.sprintf "a polynomial in time of a degree above %d is not evaluated" greatest_degree)

let small p q = Polynomial.degree p + Polynomial.degree q <= greatest_degree

let ratio (n, d) (m, e) =
  if small n m && small d e then Ratio (Polynomial.mul n m, Polynomial.mul d e) else too_high

let sum combine =
  lift (fun (n, d) (m, e) ->
      if Polynomial.equal d e then Ratio (combine n m, d)
      else if small n e && small m d && small d e then
        Ratio (combine (Polynomial.mul n e) (Polynomial.mul m d), Polynomial.mul d e)
      else too_high)

let add = sum Polynomial.add
let sub = sum Polynomial.sub
let mul = lift ratio
let neg = function Undefined r -> Undefined r | Ratio (n, d) -> Ratio (Polynomial.neg n, d)

let numerator_roots extent p =
  match (extent, Polynomial.to_constant p) with
  | Timeline.Instant, _ | _, Some _ -> []
  | Timeline.Lasts d, None -> Algebraic.roots p ~low:Rat.zero ~high:(Some d)
  | Timeline.Forever, None -> Algebraic.roots p ~low:Rat.zero ~high:None

let div ~reason extent a b =
  let divide (x, y) zero =
    if zero then Undefined reason
    else lift (fun a (m, e) -> ratio a (e, m)) x y
  in
  let vanishes sign = function _, Undefined _ -> false | _, Ratio (m, _) -> sign m = 0 in
  Timeline.refine
    ~roots:(function
        | Undefined _, _ | _, Undefined _ -> []
        | Ratio _, Ratio (m, _) -> numerator_roots extent m)
    ~at:(fun r pair -> divide pair (vanishes (fun m -> Algebraic.sign_at m r) pair))
    ~inside:(fun r pair -> divide pair (vanishes (fun m -> Polynomial.sign_at m r) pair))
    (Timeline.map2 (fun x y -> (x, y)) a b)

let of_sign comparison s = Truth.of_bool (Law.by_sign comparison s)

let compare comparison extent a b =
  let truth sign = function
    | Undefined reason -> Truth.Undecided reason
    | Ratio (n, d) -> of_sign comparison (sign n * sign d)
  in
  Timeline.refine
    ~roots:(function Undefined _ -> [] | Ratio (n, _) -> numerator_roots extent n)
    ~at:(fun r v -> truth (fun p -> Algebraic.sign_at p r) v)
    ~inside:(fun r v -> truth (fun p -> Polynomial.sign_at p r) v)
    (Timeline.map2 sub a b)
  |> Timeline.simplify Truth.equal

(* The rational of least denominator in [low, high], by continued fractions. *)
let rec simplest low high =
  if Rat.sign low <= 0 && Rat.sign high >= 0 then Rat.zero
  else if Rat.sign high < 0 then Rat.neg (simplest (Rat.neg high) (Rat.neg low))
  else
    let floor = Rat.make (Rat.floor low) Z.one in
    if Rat.equal floor low then low
    else
      let next = Rat.add floor Rat.one in
      if Rat.compare next high <= 0 then next
      else
        let inverse x = Rat.div Rat.one (Rat.sub x floor) in
        Rat.add floor (Rat.div Rat.one (simplest (inverse high) (inverse low)))

(* At an irrational offset, known near enough for a person. The value may be rational all the same: then it
   is the simplest rational close by, or else not worth telling. *)
let near n d offset =
  let tiny k = Rat.make Z.one (Z.pow (Z.of_int 10) k) in
  let low, high = Algebraic.enclose offset ~width:(tiny 30) in
  let r = Rat.middle low high in
  let bottom = Polynomial.eval d r in
  if Rat.sign bottom = 0 then "(a quotient with a divisor near 0)"
  else
    let v = Rat.div (Polynomial.eval n r) bottom in
    let c = simplest (Rat.sub v (tiny 12)) (Rat.add v (tiny 12)) in
    if Algebraic.sign_at (Polynomial.sub n (Polynomial.scale c d)) offset = 0 then Rat.to_string c
    else "about " ^ Decimal.padded ~places:6 v

let at value offset =
  match (value, Algebraic.to_rat offset) with
  | Undefined reason, _ -> reason
  | Ratio (n, d), Some r -> Rat.to_string (Rat.div (Polynomial.eval n r) (Polynomial.eval d r))
  | Ratio (n, d), None -> near n d offset
