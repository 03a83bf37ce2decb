open Scc_exact

(* [remove n p] is the number of times that [p] divides [n], and what is left of it: by squares of [p], for
   numbers of thousands of digits. ([Z.remove] of Zarith 1.12 gives wrong answers and corrupts memory.) *)
let rec remove n p =
  let q, r = Z.div_rem n p in
  if Z.sign r <> 0 then (n, 0)
  else
    let rest, k = remove q (Z.mul p p) in
    let q, r = Z.div_rem rest p in
    if Z.sign r <> 0 then (rest, (2 * k) + 1) else (q, (2 * k) + 2)

let zeros k = String.make k '0'

(* m/10^k written out, for m > 0. *)
let plain_decimal digits k =
  let n = String.length digits in
  if k = 0 then digits
  else if n > k then String.sub digits 0 (n - k) ^ "." ^ String.sub digits (n - k) k
  else "0." ^ zeros (k - n) ^ digits

(* 10^k m, for m > 0 that 10 does not divide and k > 0. *)
let plain_integer digits k = digits ^ zeros k

(* A mantissa with an exponent where that is much shorter. The limit on literals counts digits and exponent
   together; what was read within it is so written too. *)
let shorter plain digits exponent =
  let n = String.length digits in
  if String.length plain > n + 12 && n + abs exponent <= Rat.max_digits then
    Printf.sprintf "%se%d" digits exponent
  else if String.length plain > Rat.max_digits && exponent < -n then
    Printf.sprintf "0.%se%d" digits (exponent + n)
  else plain

let decimal q =
  let rest, twos = remove (Q.den q) (Z.of_int 2) in
  let rest, fives = remove rest (Z.of_int 5) in
  if not (Z.equal rest Z.one) then None
  else
    let k = max twos fives in
    let scaled = Z.mul (Q.num q) (Z.divexact (Z.pow (Z.of_int 10) k) (Q.den q)) in
    if Z.sign scaled = 0 then Some "0"
    else if k > 0 then
      let digits = Z.to_string scaled in
      Some (shorter (plain_decimal digits k) digits (-k))
    else
      let m, tens = remove scaled (Z.of_int 10) in
      let digits = Z.to_string m in
      Some (shorter (plain_integer digits tens) digits tens)

let power_of_two q =
  let rest, k = remove (Q.den q) (Z.of_int 2) in
  if Z.equal (Q.num q) Z.one && Z.equal rest Z.one && k > 0 then Some (Printf.sprintf "2^-%d" k) else None

let number q =
  match decimal (Q.abs q) with
  | Some s -> if Q.sign q < 0 then "-" ^ s else s
  | None -> Q.to_string q
