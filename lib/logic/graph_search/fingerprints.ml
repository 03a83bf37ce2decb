open Bigarray

(* Open addressing with linear probing; 0 is free. *)
type t = {
  cells : (int32, int32_elt, c_layout) Array1.t;
  capacity : int;
  mutable size : int;
  mutable compared : float;  (** fingerprints, in all answers *)
}

(* At most three quarters of the cells are taken. *)
let create ~capacity =
  let rec enough bits = if bits = 60 || 3 * (1 lsl (bits - 2)) > capacity then bits else enough (bits + 1) in
  let cells = Array1.create int32 c_layout (1 lsl enough 8) in
  Array1.fill cells 0l;
  { cells; capacity; size = 0; compared = 0. }

(* Two rounds of multiplication and shifting, as in generators of random numbers. *)
let mix k =
  let k = (k lxor (k lsr 31)) * 0x1E3779B97F4A7C15 in
  let k = (k lxor (k lsr 29)) * 0x3F58476D1CE4E5B9 in
  k lxor (k lsr 32)

(* The place comes from other bits than the fingerprint. *)
let add s key =
  let h = mix key in
  let print = Int32.of_int ((h land 0x7fff_fffe) lor 1) in
  let mask = Array1.dim s.cells - 1 in
  let rec probe i seen =
    let cell = s.cells.{i} in
    if Int32.equal cell 0l then begin
      if s.size >= s.capacity then Scc_base.Bug.fail __POS__ "more members than there is room for";
      s.cells.{i} <- print;
      s.size <- s.size + 1;
      s.compared <- s.compared +. float_of_int seen;
      true
    end
    else if Int32.equal cell print then begin
      s.compared <- s.compared +. float_of_int (seen + 1);
      false
    end
    else probe ((i + 1) land mask) (seen + 1)
  in
  probe ((mix (key lxor 0x2545F4914F6CDD1D) lsr 8) land mask) 0

(* A fingerprint has 30 bits besides the lowest, which is set. *)
let omission s = Float.min 1. (s.compared /. 1073741824.)
let bytes s = 4 * Array1.dim s.cells
