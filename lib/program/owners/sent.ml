open Bigarray
open Scc_data

(* Two numbers for each fingerprint, in either of two neighbouring places. *)
type t = {
  most : int;  (** places *)
  mutable table : (int, int_elt, c_layout) Array1.t;
  mutable places : int;
  mutable taken : int;
}

let table places =
  let t = Spill.ints (2 * places) in
  Array1.fill t 0;
  t

let least = 1 lsl 10

let create ~bytes =
  let rec below n = if 32 * n > bytes then n else below (2 * n) in
  { most = below least; table = table least; places = least; taken = 0 }

let low (p : Scc_successors.Keys.fingerprint) = p.(1) lor (p.(2) lsl 32)
let high (p : Scc_successors.Keys.fingerprint) = p.(3) lor (p.(0) lsl 32)

let[@inline] place t low = (low lxor (low lsr 29)) land (t.places - 1)
let[@inline] number t i = Array1.unsafe_get t.table i
let[@inline] is t k low high = number t (2 * k) = low && number t ((2 * k) + 1) = high

let put t k low high =
  t.table.{2 * k} <- low;
  t.table.{(2 * k) + 1} <- high

let near t print =
  let k = place t (low print) in
  number t (2 * k)

let rec add t low high =
  let k = place t low in
  let other = k lxor 1 in
  if is t k low high || is t other low high then false
  else begin
    let free = is t k 0 0 || is t other 0 0 in
    if free then t.taken <- t.taken + 1;
    put t (if is t k 0 0 || not free then k else other) low high;
    if 2 * t.taken > t.places && t.places < t.most then enlarge t;
    true
  end

and enlarge t =
  let old = t.table and places = t.places in
  t.table <- table (2 * places);
  t.places <- 2 * places;
  t.taken <- 0;
  for k = 0 to places - 1 do
    if old.{2 * k} <> 0 || old.{(2 * k) + 1} <> 0 then ignore (add t old.{2 * k} old.{(2 * k) + 1})
  done

let add t print = add t (low print) (high print)
