open Scc_exact

(* {1 Writing} *)

let rec put_nat b n =
  if n < 0x80 then Buffer.add_char b (Char.unsafe_chr n)
  else (
    Buffer.add_char b (Char.unsafe_chr (n land 0x7F lor 0x80));
    put_nat b (n lsr 7))

(* Integers of less than 30 bits are the numbers 4|z| and 4|z| + 2; others tell by 4k + 1 and 4k + 3 how many bytes
   of |z| follow. *)
let is_short z = Z.numbits z < 30

let put_integer b z =
  let minus = if Z.sign z < 0 then 2 else 0 in
  let size = Z.abs z in
  if is_short z then put_nat b ((4 * Z.to_int size) + minus)
  else
    let bytes = Z.to_bits size in
    let n = (Z.numbits size + 7) / 8 in
    put_nat b ((4 * n) + minus + 1);
    Buffer.add_substring b bytes 0 n

let put_rational b q =
  put_integer b (Q.num q);
  put_integer b (Q.den q)

let put_vector b (v : Vec.t) =
  put_rational b v.x;
  put_rational b v.y;
  put_rational b v.z

let put_list b put list =
  put_nat b (List.length list);
  List.iter (put b) list

(* {1 Reading} *)

exception Malformed of string

type source = { text : string; mutable next : int }

let source ?(from = 0) text = { text; next = from }
let place s = s.next
let left s = String.length s.text - s.next
let at_end s = left s = 0
let fail what = raise (Malformed what)

let byte s =
  if at_end s then fail "it ends too early";
  let c = Char.code s.text.[s.next] in
  s.next <- s.next + 1;
  c

let nat s =
  let rec more shift sum =
    let c = byte s in
    let sum = sum lor ((c land 0x7F) lsl shift) in
    if c >= 0x80 then if shift >= 49 then fail "a number is too long" else more (shift + 7) sum
    else if c = 0 && shift > 0 then fail "a number has a digit 0 in front"
    else sum
  in
  more 0 0

let below limit ~what s =
  let n = nat s in
  if n < limit then n else fail (Printf.sprintf "%s %d is not there" what n)

let integer s =
  let head = nat s in
  let signed z = if head land 2 = 0 then z else if Z.sign z = 0 then fail "minus zero" else Z.neg z in
  if head land 1 = 0 then
    let z = Z.of_int (head / 4) in
    if is_short z then signed z else fail "a number that needs no bytes has them"
  else
    let n = head / 4 in
    if n > left s then fail "a number is longer than what is there";
    let z = Z.of_bits (String.sub s.text s.next n) in
    s.next <- s.next + n;
    if is_short z || (Z.numbits z + 7) / 8 <> n then fail "a number has a digit 0 in front" else signed z

let rational s =
  let num = integer s in
  let den = integer s in
  if Z.sign den <= 0 then fail "a denominator is not positive"
  else if not (Z.equal (Z.gcd num den) Z.one) then fail "a fraction is not in lowest terms"
  else Rat.make num den

let vector s =
  let x = rational s in
  let y = rational s in
  let z = rational s in
  Vec.make x y z

let text s =
  let n = nat s in
  if n > left s then fail "a text is longer than what is there";
  let text = String.sub s.text s.next n in
  s.next <- s.next + n;
  text

let list s item =
  let n = nat s in
  if n > left s then fail "a list is longer than what is there";
  List.init n (fun _ -> item s)
