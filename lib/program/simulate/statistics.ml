open Scc_exact

(* The sums are exact, so that the order in which values come does not matter. *)
type t = { count : int; sum : Rat.t; squares : Rat.t; values : Rat.t list; sorted : Rat.t array Lazy.t }

let sort values = lazy (let a = Array.of_list values in Array.sort Rat.compare a; a)
let empty = { count = 0; sum = Rat.zero; squares = Rat.zero; values = []; sorted = sort [] }

let add t x =
  let values = x :: t.values in
  {
    count = t.count + 1;
    sum = Rat.add t.sum x;
    squares = Rat.add t.squares (Rat.mul x x);
    values;
    sorted = sort values;
  }

let count t = t.count
let mean t = Rat.div t.sum (Rat.of_int t.count)

let variance t =
  if t.count < 2 then None
  else
    let around = Rat.sub t.squares (Rat.mul t.sum (mean t)) in
    Some (Rat.div around (Rat.of_int (t.count - 1)))

let sorted t = Lazy.force t.sorted
let at t i = (Lazy.force t.sorted).(i)
let least t = at t 0
let greatest t = at t (t.count - 1)

let quantile t q =
  let rank = Z.neg (Rat.floor (Rat.neg (Rat.mul q (Rat.of_int t.count)))) in
  at t (Int.max 0 (Int.min (t.count - 1) (Z.to_int rank - 1)))

(* floor (sqrt x + 1/2) is the half, rounded down, of floor (sqrt (4 x)) + 1. *)
let root ~decimals x =
  let scale = Z.pow (Z.of_int 10) decimals in
  let scaled = Rat.floor (Rat.mul (Rat.mul x (Rat.of_int 4)) (Rat.make (Z.mul scale scale) Z.one)) in
  let rounded = Z.shift_right (Z.succ (Z.sqrt scaled)) 1 in
  Decimal.padded ~places:decimals (Rat.make rounded scale)
