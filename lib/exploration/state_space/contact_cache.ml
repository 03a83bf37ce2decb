open Scc_exact

(* A table of cells: the number of a pair, and its code beside it. A code is a rank and, in the lowest bit,
   whether it is only that of a bound. The rank of a float that is not negative is its bits without the last two,
   so that it fits: bits are in the order of the floats. That of a rational is the rank of the nearest float, and
   rounding to the nearest keeps the order, also with regard to floats. *)
type t = {
  most : int;
  mutable cells : int array;
  mutable times : Rat.t array;
  mutable kept : int;  (** since it was made so large *)
}

type code = int

let first_size = 1 lsl 10
let no_pair = -1
let meeting = -1
let unknown = -2
let never = max_int
let rank_of_float time = Int64.to_int (Int64.shift_right_logical (Int64.bits_of_float time) 2)
let[@inline] is_exact code = code land 1 = 0
let[@inline] rank code = code lsr 1
let rank_of time = rank_of_float (Rat.to_float time)

let create ~most =
  let size = Int.min most first_size in
  { most; cells = Array.make (2 * size) no_pair; times = Array.make size Rat.zero; kept = 0 }

let[@inline] place size pair = (((pair lxor (pair lsr 29)) * 0x1E3779B97F4A7C15) lsr 30) land (size - 1)

let[@inline] find t pair =
  let i = place (Array.length t.times) pair in
  if Array.unsafe_get t.cells (2 * i) = pair then Array.unsafe_get t.cells ((2 * i) + 1) else unknown

let time t pair = t.times.(place (Array.length t.times) pair)

let put cells times pair code time =
  let i = place (Array.length times) pair in
  cells.(2 * i) <- pair;
  cells.((2 * i) + 1) <- code;
  times.(i) <- time

(* Made to the end before it takes the place of the old one: work may be given up anywhere. *)
let enlarge t =
  let size = 2 * Array.length t.times in
  let cells = Array.make (2 * size) no_pair and times = Array.make size Rat.zero in
  Array.iteri
    (fun i time -> if t.cells.(2 * i) <> no_pair then put cells times t.cells.(2 * i) t.cells.((2 * i) + 1) time)
    t.times;
  t.cells <- cells;
  t.times <- times;
  t.kept <- 0

let keep t pair code time =
  let size = Array.length t.times in
  if t.kept >= size && size < t.most then enlarge t;
  put t.cells t.times pair code time;
  t.kept <- t.kept + 1

let keep_never t pair = keep t pair never Rat.zero
let keep_meeting t pair = keep t pair meeting Rat.zero
let keep_time t pair time = keep t pair (rank_of time lsl 1) time
let keep_not_before t pair bound = keep t pair ((rank_of_float bound lsl 1) lor 1) Rat.zero
