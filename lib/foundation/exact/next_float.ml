(* Floats of one sign are in the order of their bits. *)
let[@inline] moved x by = Int64.float_of_bits (Int64.add (Int64.bits_of_float x) by)

let[@inline] succ x =
  if x > 0. then if x < infinity then moved x 1L else x
  else if x < 0. then moved x (-1L)
  else if x = 0. then 0x1p-1074
  else x

let[@inline] pred x = -.succ (-.x)

(* What a sum that is rounded to the nearest lacks is itself a float, and this is it (Knuth); no number, where
   something is infinite. *)
let[@inline] rest a b sum =
  let b' = sum -. a in
  (a -. (sum -. b')) +. (b -. b')

let[@inline] sum_below a b =
  let sum = a +. b in
  if rest a b sum >= 0. then sum else pred sum

let[@inline] sum_above a b =
  let sum = a +. b in
  if rest a b sum <= 0. then sum else succ sum

