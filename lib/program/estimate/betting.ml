open Scc_exact

(* {1 Numbers}

   Positive floats with a wide exponent, m 2^e. Multiplication rounds m once, and the rest is exact. *)

type number = { m : float; e : int }

let wide = 200
let much = Float.ldexp 1. wide
let little = Float.ldexp 1. (-wide)

let normal m e =
  if m >= much then { m = m *. little; e = e + wide }
  else if m < little then { m = m *. much; e = e - wide }
  else { m; e }

let mul a b = normal (a.m *. b.m) (a.e + b.e)

let rec power a n =
  if n = 1 then a
  else
    let half = power a (n / 2) in
    let square = mul half half in
    if n mod 2 = 0 then square else mul square a

(* {1 Bets} *)

(* The stakes 2^j / (1 + 2^j), with weights whose sum is 0.998: for samples of some hundreds or thousands, and for
   others. *)
let bets = Array.init 45 (fun i -> (i - 32, 1. /. float_of_int (5 * (2 + abs (i - 28)))))

(* The product of (1 + 2^j x/m) / (1 + 2^j) over all runs. *)
let capital values ~runs ~mean j =
  let odds = Float.ldexp 1. j in
  let all = 1. +. odds in
  let gain product (x, count) = mul product (power (normal ((1. +. (odds *. (x /. mean))) /. all) 0) count) in
  let some = Array.fold_left (fun n (_, count) -> n + count) 0 values in
  let first = if some = runs then { m = 1.; e = 0 } else power { m = 1. /. all; e = 0 } (runs - some) in
  Array.fold_left gain first values

(* Floats are rounded at most 5 times for each run and 100 times for the bets, each time by a factor of at most
   1 + 2^-53. What is left out of the sum is positive, as are all of its terms. *)
let proved values ~runs ~mean limit =
  let term (j, weight) =
    let c = capital values ~runs ~mean j in
    { c with m = weight *. c.m }
  in
  let terms = Array.map term bets in
  let top = Array.fold_left (fun top n -> Int.max top n.e) min_int terms in
  let add sum n = if top - n.e > 2 * wide then sum else sum +. Float.ldexp n.m (n.e - top) in
  let sum = Q.of_float (Array.fold_left add 0. terms) in
  let kept = Rat.sub Rat.one (Rat.make (Z.of_int ((5 * runs) + 100)) (Z.shift_left Z.one 53)) in
  let enough = Rat.mul limit (Rat.power_of_two (-Int.min top 100_000)) in
  top > -100_000 && Rat.compare (Rat.mul sum kept) enough >= 0

(* {1 Bounds} *)

(* The power of ten of which [r] > 0 has ten digits before the point. *)
let unit_of (r : Rat.t) =
  let ten k =
    let power = Rat.make (Z.pow (Z.of_int 10) (Int.abs k)) Z.one in
    if k >= 0 then power else Rat.div Rat.one power
  in
  let rec up k = if Rat.compare (ten (k + 1)) r <= 0 then up (k + 1) else k in
  let bits = Z.numbits r.num - Z.numbits r.den in
  ten (up ((if bits > 0 then bits * 3 / 10 else bits * 31 / 100) - 2) - 9)

(* A float that is at most [r] >= 0: 53 of its digits. *)
let below r =
  let z = Rat.floor (Rat.mul r (Rat.power_of_two 20)) in
  let extra = Int.max 0 (Z.numbits z - 53) in
  Float.ldexp (Z.to_float (Z.shift_right z extra)) (extra - 20)

let lower values ~runs ~miss =
  let sum = List.fold_left (fun sum (x, n) -> Rat.add sum (Rat.mul (Rat.of_int n) x)) Rat.zero values in
  if Rat.sign sum = 0 then Rat.zero
  else begin
    let mean = Rat.div sum (Rat.of_int runs) in
    let unit = unit_of mean in
    let scaled = Array.of_list (List.map (fun (x, n) -> (below (Rat.div x unit), n)) values) in
    let limit = Rat.div Rat.one miss in
    let rec between low high =
      if high - low <= 1 then low
      else
        let middle = low + ((high - low) / 2) in
        if proved scaled ~runs ~mean:(float_of_int middle) limit then between middle high else between low middle
    in
    let most = Z.to_int (Rat.floor (Rat.div mean unit)) + 1 in
    Rat.mul (Rat.of_int (between 0 most)) unit
  end
