open Scc_exact

(* How often [p] divides [n], at most so often, and what remains. *)
let rec times p n ~most k =
  let q, r = Z.div_rem n p in
  if k < most && Z.sign r = 0 then times p q ~most (k + 1) else (k, n)

let exact q =
  let most = Text.max_digits in
  if Rat.bits q > 8 * most then None
  else
    let twos, rest = times (Z.of_int 2) (Q.den q) ~most 0 in
    let fives, rest = times (Z.of_int 5) rest ~most 0 in
    let places = max twos fives in
    if not (Z.equal rest Z.one) then None
    else
      let digits = Z.to_string (Z.abs (Z.div (Z.mul (Q.num q) (Z.pow (Z.of_int 10) places)) (Q.den q))) in
      let short = places + 1 - String.length digits in
      let digits = if short > 0 then String.make short '0' ^ digits else digits in
      let n = String.length digits in
      if n > most - 2 then None
      else
        let sign = if Rat.sign q < 0 then "-" else "" in
        let whole = sign ^ String.sub digits 0 (n - places) in
        Some (if places = 0 then whole else whole ^ "." ^ String.sub digits (n - places) places)

let rounded q =
  let x = Rat.to_float q in
  if Float.is_finite x then Some (Q.of_float x) else None
