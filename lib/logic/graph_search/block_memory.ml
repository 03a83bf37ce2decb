open Bigarray

type numbers = (int, int_elt, c_layout) Array1.t

(* Four numbers for each entry: the block, its changes, and what it is after them. *)
type t = { mutable entries : numbers; mutable kept : int  (** since it was made so large *) }

let first_size = 1 lsl 8
let most = 1 lsl 15

let empty size : numbers =
  let entries = Array1.create int c_layout (4 * size) in
  Array1.fill entries (-1);
  entries

let create () = { entries = empty first_size; kept = 0 }

let[@inline] place (entries : numbers) id one two =
  let mixed = ((((id * 0x1E3779B97F4A7C15) lxor one) * 0x1E3779B97F4A7C15) lxor two) * 0x1E3779B97F4A7C15 in
  (mixed lsr 32) land (Array1.dim entries - 4)

let find t id one two =
  let entries = t.entries in
  let at = place entries id one two in
  if
    Array1.unsafe_get entries at = id
    && Array1.unsafe_get entries (at + 1) = one
    && Array1.unsafe_get entries (at + 2) = two
  then Array1.unsafe_get entries (at + 3)
  else -1

let put entries id one two after =
  let at = place entries id one two in
  entries.{at} <- id;
  entries.{at + 1} <- one;
  entries.{at + 2} <- two;
  entries.{at + 3} <- after

(* Made to the end before it takes the place of the old one: work may be given up anywhere. *)
let enlarge t =
  let old = t.entries in
  let entries = empty (2 * (Array1.dim old / 4)) in
  for k = 0 to (Array1.dim old / 4) - 1 do
    let at = 4 * k in
    if old.{at} >= 0 then put entries old.{at} old.{at + 1} old.{at + 2} old.{at + 3}
  done;
  t.entries <- entries;
  t.kept <- 0

let keep t id one two after =
  let size = Array1.dim t.entries / 4 in
  if t.kept >= size && size < most then enlarge t;
  t.kept <- t.kept + 1;
  put t.entries id one two after
