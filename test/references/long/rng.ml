open Scc_exact

type t = { mutable state : int64 }

let mix shift factor z = Int64.mul (Int64.logxor z (Int64.shift_right_logical z shift)) factor

let scramble z =
  let z = mix 27 0x94D049BB133111EBL (mix 30 0xBF58476D1CE4E5B9L z) in
  Int64.logxor z (Int64.shift_right_logical z 31)

let golden = 0x9E3779B97F4A7C15L

let make keys =
  let add state key = scramble (Int64.add (Int64.mul golden (Int64.add state 1L)) (Int64.of_int key)) in
  { state = List.fold_left add 0L keys }

let bits g =
  g.state <- Int64.add g.state golden;
  Int64.to_int (Int64.shift_right_logical (scramble g.state) 2)

(* The small ranges of the tests: no need to mind the remainder of 2^62. *)
let below g n = bits g mod n
let range g low high = low + below g (high - low + 1)
let chance g n = below g n = 0
let choose g xs = xs.(below g (Array.length xs))

let rec positive g k =
  if k <= 30 then Z.of_int (1 + below g (1 lsl k))
  else Z.add (Z.shift_left (Z.pred (positive g (k - 30))) 30) (positive g 30)

let fraction g n =
  let d = range g 2 n in
  Rat.make (Z.of_int (range g (1 - d) (d - 1))) (Z.of_int d)

let rec vector g n =
  let c () = range g (-n) n in
  let x = c () in
  let y = c () in
  let v = Vec.of_ints x y (c ()) in
  if Vec.is_zero v then vector g n else v
