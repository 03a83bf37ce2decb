type t = int64

let of_seed seed = seed

let next state =
  let state = Int64.add state 0x9E3779B97F4A7C15L in
  let mix shift factor z = Int64.mul (Int64.logxor z (Int64.shift_right_logical z shift)) factor in
  let z = mix 27 0x94D049BB133111EBL (mix 30 0xBF58476D1CE4E5B9L state) in
  (Int64.logxor z (Int64.shift_right_logical z 31), state)

let rec below n g =
  let raw, g = next g in
  let bits = Int64.shift_right_logical raw 1 in
  let n64 = Int64.of_int n in
  let r = Int64.rem bits n64 in
  (* bits - r + (n - 1) passes 2^63 - 1 exactly in the last, incomplete block *)
  if Int64.compare (Int64.add (Int64.sub bits r) (Int64.pred n64)) 0L < 0 then below n g
  else (Int64.to_int r, g)

(* An integer from 0 to n - 1, each equally likely: the highest bits, as many as n - 1 has, of as few outputs as
   needed, one after the other. It is drawn again until it is less than n. *)
let rec below_long n g =
  let rec outputs bits raw g =
    if bits = 0 then (raw, g)
    else
      let next, g = next g in
      let unsigned = Z.extract (Z.of_int64 next) 0 64 in
      outputs (bits - 1) (Z.logor (Z.shift_left raw 64) unsigned) g
  in
  let width = Z.numbits (Z.pred n) in
  let count = (width + 63) / 64 in
  let raw, g = outputs count Z.zero g in
  let r = Z.shift_right raw ((64 * count) - width) in
  if Z.lt r n then (r, g) else below_long n g

(* The same, of one output. *)
let rec below_short n ~width g =
  let raw, g = next g in
  let r = Int64.to_int (Int64.shift_right_logical raw (64 - width)) in
  if r < n then (Z.of_int r, g) else below_short n ~width g

let below_integer n g =
  let width = Z.numbits (Z.pred n) in
  if Z.fits_int n && width > 0 then below_short (Z.to_int n) ~width g else below_long n g

let by_chance (chances : Scc_exact.Rat.t array) g =
  (* Most have one denominator; where it is small it is the same word. *)
  let same d e = d == e || Z.equal d e in
  let common =
    Array.fold_left (fun d (c : Scc_exact.Rat.t) -> if same d c.den then d else Z.lcm d c.den) Z.one chances
  in
  let weight (c : Scc_exact.Rat.t) =
    if same c.den common then c.num else Z.mul c.num (Z.divexact common c.den)
  in
  let drawn, g = below_integer (Array.fold_left (fun sum c -> Z.add sum (weight c)) Z.zero chances) g in
  let rec place i left =
    let w = weight chances.(i) in
    if Z.geq left w then place (i + 1) (Z.sub left w) else i
  in
  (place 0 drawn, g)
