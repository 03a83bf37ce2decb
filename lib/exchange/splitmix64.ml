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
