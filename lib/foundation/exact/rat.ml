type t = Q.t

let zero = Q.zero
let one = Q.one
let of_int = Q.of_int
let make = Q.make
let add = Q.add
let sub = Q.sub
let mul = Q.mul

let div a b =
  if Q.sign b = 0 then Scc_base.Bug.fail __POS__ "division by zero" else Q.div a b

let neg = Q.neg
let abs = Q.abs
let sign = Q.sign

(* Most of what is compared is one and the same number, which many states share. *)
let equal a b = a == b || Q.equal a b

(* Nor do most others have two denominators; where they are small they are the same word. *)
let compare a b =
  if a == b then 0
  else if Q.den a == Q.den b then Z.compare (Q.num a) (Q.num b)
  else Q.compare a b

let min a b = if compare a b <= 0 then a else b
let max a b = if compare a b >= 0 then a else b
let half = Q.of_ints 1 2
let middle a b = Q.div (Q.add a b) (Q.of_int 2)
let span x rest = (List.fold_left min x rest, List.fold_left max x rest)
let hash x = (Z.hash (Q.num x) * 31) + Z.hash (Q.den x)
let is_integer x = Z.equal (Q.den x) Z.one
let floor x = Z.fdiv (Q.num x) (Q.den x)

let round_to x ~quantum =
  let k = Q.div (Q.abs x) quantum in
  let n = floor (Q.add k half) in
  let r = Q.mul (Q.of_bigint n) quantum in
  if Q.sign x < 0 then Q.neg r else r

let modulo x m = Q.sub x (Q.mul m (Q.of_bigint (floor (Q.div x m))))
let to_string = Q.to_string

(* Two integers that floats hold exactly have a quotient that is rounded once. [Q.to_float] of Zarith 1.12 rounds
   correctly too, but slowly. *)
let exact_float = 1 lsl 53

let to_float x =
  let n = Q.num x and d = Q.den x in
  if d == Z.one && Z.fits_int n then float_of_int (Z.to_int n)
  else if Z.fits_int n && Z.fits_int d then
    let n = Z.to_int n and d = Z.to_int d in
    if n <= exact_float && n >= -exact_float && d <= exact_float && d > 0 then
      float_of_int n /. float_of_int d
    else Q.to_float x
  else Q.to_float x

let is_float x =
  let n = Q.num x and d = Q.den x in
  Z.fits_int n && Z.fits_int d
  &&
  let n = Z.to_int n and d = Z.to_int d in
  n <= exact_float && n >= -exact_float && d > 0 && d land (d - 1) = 0

let near_float_of_great n d x =
  let n = Z.to_float n and d = Z.to_float d in
  if Float.abs n < 0x1p1000 && d < 0x1p1000 then n /. d else Q.to_float x

(* What fits into machine integers is not put into boxes. *)
let[@inline] near_float x =
  let n = Q.num x and d = Q.den x in
  if Z.fits_int n && Z.fits_int d then float_of_int (Z.to_int n) /. float_of_int (Z.to_int d)
  else near_float_of_great n d x

let bits x = Z.numbits (Q.num x) + Z.numbits (Q.den x)
let max_digits = 4_000

type literal_error = Malformed | Too_large | Zero_denominator

let is_digit c = c >= '0' && c <= '9'

(* [digits s i] is the end of the run of digits of [s] that starts at [i]. *)
let rec digits s i = if i < String.length s && is_digit s.[i] then digits s (i + 1) else i

(* [zeros s i] is the end of the run of zeros of [s] that starts at [i]. *)
let rec zeros s i = if i < String.length s && s.[i] = '0' then zeros s (i + 1) else i

let unsigned_decimal s =
  let n = String.length s in
  let i = digits s 0 in
  let j = if i < n && s.[i] = '.' then digits s (i + 1) else i in
  let fraction = if j > i then j - i - 1 else 0 in
  if i = 0 || (j = i + 1) then Error Malformed
  else if i + fraction > max_digits then Error Too_large
  else
    let exponent =
      if j = n then Ok 0
      else if s.[j] <> 'e' && s.[j] <> 'E' then Error Malformed
      else
        let k = if j + 1 < n && (s.[j + 1] = '-' || s.[j + 1] = '+') then j + 2 else j + 1 in
        if k >= n || digits s k <> n then Error Malformed
        else
          let first = zeros s k in
          if n - first > 9 then Error Too_large
          else
            let e = int_of_string ("0u0" ^ String.sub s first (n - first)) in
            Ok (if s.[j + 1] = '-' then -e else e)
    in
    match exponent with
    | Error e -> Error e
    | Ok e when i + fraction + Stdlib.abs e > max_digits -> Error Too_large
    | Ok e ->
      let whole = String.sub s 0 i in
      let part = if fraction > 0 then String.sub s (i + 1) fraction else "" in
      let mantissa = Z.of_string (whole ^ part) in
      let shift = e - fraction in
      let ten k = Z.pow (Z.of_int 10) k in
      Ok
        (if shift >= 0 then Q.of_bigint (Z.mul mantissa (ten shift))
         else Q.make mantissa (ten (-shift)))

let unsigned s =
  match String.index_opt s '/' with
  | None -> unsigned_decimal s
  | Some i -> (
      let n = String.length s in
      match (unsigned_decimal (String.sub s 0 i), unsigned_decimal (String.sub s (i + 1) (n - i - 1))) with
      | Error e, _ | _, Error e -> Error e
      | Ok _, Ok d when Q.sign d = 0 -> Error Zero_denominator
      | Ok a, Ok d -> Ok (Q.div a d))

let of_literal s =
  if String.length s = 0 then Error Malformed
  else
    let tail () = String.sub s 1 (String.length s - 1) in
    match s.[0] with
    | '-' -> Result.map Q.neg (unsigned (tail ()))
    | '+' -> unsigned (tail ())
    | _ -> unsigned s

(* n/d 2^k for an integer k of either sign, rounded up to an integer. *)
let scaled_up n d k = if k >= 0 then Z.cdiv (Z.shift_left n k) d else Z.cdiv n (Z.shift_left d (-k))
let over_power n k = if k >= 0 then Q.make n (Z.shift_left Z.one k) else Q.of_bigint (Z.shift_left n (-k))
let power_of_two k = over_power Z.one (-k)

(* 2^(size - 1) < n/d < 2^(size + 1), for positive n and d. *)
let size n d = Z.numbits n - Z.numbits d
let kept = 10

let short_above q =
  if Q.sign q = 0 then Q.zero
  else
    let k = kept - size (Q.num q) (Q.den q) in
    over_power (scaled_up (Q.num q) (Q.den q) k) k

let root_above ~kept n d =
  if Z.sign n = 0 then Q.zero
  else
    let k = ((2 * kept) - size n d) asr 1 in
    let n = scaled_up n d (2 * k) in
    let root = Z.sqrt n in
    over_power (if Z.lt (Z.mul root root) n then Z.succ root else root) k

let sqrt_above n d = root_above ~kept n d

let root_to ~bits q =
  let n = Q.num q and d = Q.den q in
  if Z.perfect_square n && Z.perfect_square d then Q.make (Z.sqrt n) (Z.sqrt d) else root_above ~kept:bits n d

let root q = root_to ~bits:40 q

let log_above q =
  let q = Q.abs q in
  if Q.sign q = 0 then 0 else Int.max 0 (size (Q.num q) (Q.den q) + 1)
