open Scc_exact

(* {1 Numbers}

   Positive ones, m 2^e, or 0; every operation is rounded up. *)

type number = { m : Z.t; e : int }

let digits = 192

let round m e =
  let extra = Z.numbits m - digits in
  if extra <= 0 then { m; e } else { m = Z.cdiv m (Z.shift_left Z.one extra); e = e + extra }

let mul a b = round (Z.mul a.m b.m) (a.e + b.e)
let one = { m = Z.one; e = 0 }

(* More than 0. What is far below the other number is one unit of a place below its last one at most. *)
let add a b =
  let high, low = if a.e + Z.numbits a.m >= b.e + Z.numbits b.m then (a, b) else (b, a) in
  let gap = high.e - low.e in
  if gap > 4 * digits then round (Z.succ (Z.shift_left high.m digits)) (high.e - digits)
  else if gap >= 0 then round (Z.add (Z.shift_left high.m gap) low.m) low.e
  else round (Z.add high.m (Z.shift_left low.m (-gap))) high.e

let of_fraction num den =
  let shift = Int.max 0 (digits + Z.numbits den - Z.numbits num) in
  round (Z.cdiv (Z.shift_left num shift) den) (-shift)

let rec power a n =
  if n = 0 then one
  else
    let half = power a (n / 2) in
    let square = mul half half in
    if n mod 2 = 0 then square else mul square a

let at_most_rat a (r : Rat.t) =
  let num, den = (r.num, r.den) in
  if a.e >= 0 then Z.leq (Z.mul (Z.shift_left a.m a.e) den) num
  else Z.leq (Z.mul a.m den) (Z.shift_left num (-a.e))

(* By their sizes alone: it may be less without that. *)
let surely_less a b = a.e + Z.numbits a.m < b.e + Z.numbits b.m

(* {1 Tails} *)

type coefficient = { n : int; k : int; ways : number  (** n over k, rounded up *) }

let coefficient ~n ~k =
  let few = Int.min k (n - k) in
  let rec go i ways =
    if i > few then ways
    else go (i + 1) (mul ways (of_fraction (Z.of_int (n - few + i)) (Z.of_int i)))
  in
  { n; k; ways = go 1 one }

(* Far above the mean each term is the one before times a ratio that is less than 1, and only becomes less: what
   comes after some term is not more than that of a geometric series. *)
let tail_above c (p : Rat.t) =
  let q = Rat.sub Rat.one p in
  let odds = Rat.div p q in
  let ratio i =
    of_fraction (Z.mul (Z.of_int (c.n - i)) odds.num) (Z.mul (Z.of_int (i + 1)) odds.den)
  in
  let chance (r : Rat.t) = of_fraction r.num r.den in
  let first = mul c.ways (mul (power (chance p) c.k) (power (chance q) (c.n - c.k))) in
  let rest i term =
    let r = Rat.mul odds (Rat.make (Z.of_int (c.n - i)) (Z.of_int (i + 1))) in
    let r = Rat.div r (Rat.sub Rat.one r) in
    mul term (chance r)
  in
  let rec go i term sum =
    if i = c.n then sum
    else
      let left = rest i term in
      if surely_less left { sum with e = sum.e - 64 } then add sum left
      else
        let term = mul term (ratio i) in
        go (i + 1) term (add sum term)
  in
  go c.k first first

(* The median is at least the mean rounded down, so that up to there the tail is at least 1/2. *)
let at_most c ~chance limit =
  let mean = Rat.mul chance (Rat.of_int c.n) in
  if Rat.sign chance = 0 then c.k > 0
  else if Rat.compare (Rat.of_int c.k) mean <= 0 || Rat.compare chance Rat.one >= 0 then false
  else at_most_rat (tail_above c chance) limit
