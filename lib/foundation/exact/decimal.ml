open Scc_base

let power n = Z.pow (Z.of_int 10) n
let ten_to n = if n >= 0 then Q.of_bigint (power n) else Rat.make Z.one (power (-n))

(* [scaled n places] is n / 10^places, for n >= 0. *)
let scaled n places =
  let digits = Z.to_string n in
  let missing = places + 1 - String.length digits in
  let digits = if missing > 0 then String.make missing '0' ^ digits else digits in
  let whole = String.length digits - places in
  if places = 0 then digits
  else String.sub digits 0 whole ^ "." ^ String.sub digits whole places

(* Without zeros at the end of a fraction. *)
let stripped text =
  match String.index_opt text '.' with
  | None -> text
  | Some point ->
    let rec last i = if text.[i] = '0' then last (i - 1) else i in
    let i = last (String.length text - 1) in
    String.sub text 0 (if i = point then i else i + 1)

let nearest x = Rat.floor (Rat.add x (Rat.half))
let above x = Z.neg (Rat.floor (Rat.neg x))

(* A size, rounded, is [digits] 10^[exponent]. *)
type rounded = { digits : Z.t; exponent : int }

let value r = Rat.mul (Q.of_bigint r.digits) (ten_to r.exponent)
let at_exponent round size exponent = { digits = round (Rat.div size (ten_to exponent)); exponent }

let order_of_magnitude x =
  (* the lengths of numerator and denominator tell it but for 1 *)
  let length z = String.length (Z.to_string z) in
  let n = length (Q.num x) - length (Q.den x) in
  if Rat.compare x (ten_to n) < 0 then n - 1 else n

(* To so many digits, from the first that is not 0 on; and the power of ten of that one. *)
let to_digits round ~digits size =
  let at n = at_exponent round size (n - digits + 1) in
  let n = order_of_magnitude size in
  (* rounded up to a power of 10, it has one digit more *)
  let n = if Z.geq (at n).digits (power digits) then n + 1 else n in
  (at n, n)

let signed x text = if Rat.sign x < 0 then "-" ^ text else text
let signed_if_any x (r : rounded) text = if Z.sign r.digits = 0 then text else signed x text

let padded ~places x =
  let r = at_exponent nearest (Rat.abs x) (-places) in
  signed_if_any x r (scaled r.digits places)

let fixed ~places x = stripped (padded ~places x)
let rounded_to round ~places x = fixed ~places (value (at_exponent round x (-places)))
let rounded_down = rounded_to Rat.floor
let rounded_up = rounded_to above

(* [digits] of the number, of which the first is of 10^n. *)
let with_power r ~digits n = (scaled r.digits (digits - 1), "e" ^ string_of_int n)

let significant_by round ~digits x =
  if Rat.sign x = 0 then "0"
  else
    let r, n = to_digits round ~digits (Rat.abs x) in
    let text =
      if n < -5 || n > 8 then
        let mantissa, power = with_power r ~digits n in
        stripped mantissa ^ power
      else if n < digits then stripped (scaled r.digits (digits - 1 - n))
      else Z.to_string (Q.num (value r))
    in
    signed x text

let significant = significant_by nearest
let significant_above ~digits x =
  if Rat.sign x < 0 then Bug.fail __POS__ "a number below 0" else significant_by above ~digits x

let in_short ~most x =
  let text = Rat.to_string x in
  if String.length text <= most then text else "about " ^ significant ~digits:6 x

let exact x =
  let places = 12 in
  let shifted = Rat.mul x (Q.of_bigint (power places)) in
  if Rat.is_integer shifted then Some (fixed ~places x) else None

(* {1 Marked} *)

let least_plain = Rat.make Z.one (Z.of_int 1000)
let greatest_plain = Rat.of_int 1_000_000_000
let marked_places = 6
let marked_digits = 7

let marked x =
  let size = Rat.abs x in
  let plain =
    Rat.sign x = 0 || (Rat.compare least_plain size <= 0 && Rat.compare size greatest_plain < 0)
  in
  let told r (digits, power) =
    let is_exact = Rat.equal (value r) size in
    let digits = if is_exact then stripped digits else digits in
    (if is_exact then "" else "~") ^ signed_if_any x r (digits ^ power)
  in
  if plain then
    let r = at_exponent nearest size (-marked_places) in
    told r (scaled r.digits marked_places, "")
  else
    let r, n = to_digits nearest ~digits:marked_digits size in
    told r (with_power r ~digits:marked_digits n)
