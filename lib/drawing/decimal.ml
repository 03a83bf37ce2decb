open Scc_exact

let power n = Z.pow (Z.of_int 10) n

(* [scaled n places] is n / 10^places, for n >= 0, without zeros at the end. *)
let scaled n places =
  let digits = Z.to_string n in
  let missing = places + 1 - String.length digits in
  let digits = if missing > 0 then String.make missing '0' ^ digits else digits in
  let whole = String.sub digits 0 (String.length digits - places) in
  let rec last i = if i > 0 && digits.[String.length digits - places + i - 1] = '0' then last (i - 1) else i in
  let kept = last places in
  if kept = 0 then whole else whole ^ "." ^ String.sub digits (String.length whole) kept

let signed x text = if Rat.sign x < 0 && text <> "0" then "-" ^ text else text

let nearest x = Rat.floor (Rat.add x (Rat.make Z.one (Z.of_int 2)))

let fixed ~places x = signed x (scaled (nearest (Rat.mul (Rat.abs x) (Q.of_bigint (power places)))) places)

let ten_to n = if n >= 0 then Q.of_bigint (power n) else Rat.make Z.one (power (-n))

(* The greatest n with 10^n <= x, for x > 0: the lengths of numerator and denominator tell it but for 1. *)
let order_of_magnitude x =
  let length z = String.length (Z.to_string z) in
  let n = length (Q.num x) - length (Q.den x) in
  if Rat.compare x (ten_to n) < 0 then n - 1 else n

let significant_by round ~digits x =
  if Rat.sign x = 0 then "0"
  else
    let size = Rat.abs x in
    let at n = round (Rat.div size (ten_to (n - digits + 1))) in
    let n = order_of_magnitude size in
    (* rounded up to a power of 10, it has one digit more *)
    let n = if Z.geq (at n) (power digits) then n + 1 else n in
    let text =
      if n < -5 || n > 8 then scaled (at n) (digits - 1) ^ "e" ^ string_of_int n
      else if n < digits then scaled (at n) (digits - 1 - n)
      else Z.to_string (Z.mul (at n) (power (n - digits + 1)))
    in
    signed x text

let significant = significant_by nearest
let significant_above = significant_by (fun x -> Z.neg (Rat.floor (Rat.neg x)))

let exact x =
  let places = 12 in
  let shifted = Rat.mul x (Q.of_bigint (power places)) in
  if Rat.is_integer shifted then Some (fixed ~places x) else None
