open Bigarray

type narrow = (int, int16_signed_elt, c_layout) Array1.t
type wide = (int32, int32_elt, c_layout) Array1.t

(* Chunks of [span] numbers. One whose numbers are all equal is flat: it has no cells, but stands for its base; in
   one whose numbers are all near the base, cells have the differences from it. *)
type t = {
  mutable flat : Bytes.t;  (** 'y' of a chunk that is *)
  mutable wide : wide array;
  mutable narrow : narrow array;
  mutable base : int array;
  mutable length : int;
}

let bits = 12
let span = 1 lsl bits
let no_wide : wide = Array1.create int32 c_layout 0
let no_narrow : narrow = Array1.create int16_signed c_layout 0
let create () = { flat = Bytes.empty; wide = [||]; narrow = [||]; base = [||]; length = 0 }
let length v = v.length

let[@inline] check v i = if i < 0 || i >= v.length then Scc_base.Bug.fail __POS__ "an index out of range"

let from_cells v k at =
  let narrow : narrow = Array.unsafe_get v.narrow k in
  if Array1.dim narrow > 0 then Array.unsafe_get v.base k + Array1.unsafe_get narrow at
  else
    let wide : wide = Array.unsafe_get v.wide k in
    Int32.to_int (Array1.unsafe_get wide at)

let[@inline] is_flat v k = Char.equal (Bytes.unsafe_get v.flat k) 'y'

let[@inline] get v i =
  check v i;
  let k = i lsr bits in
  if is_flat v k then Array.unsafe_get v.base k else from_cells v k (i land (span - 1))

let[@inline] fits x = x >= -0x8000_0000 && x <= 0x7fff_ffff
let[@inline] is_near x = x >= -0x8000 && x <= 0x7fff

let narrow_of v k =
  let narrow = v.narrow.(k) in
  if Array1.dim narrow > 0 then narrow
  else begin
    let narrow = Spill.int16s span in
    Array1.fill narrow 0;
    v.narrow.(k) <- narrow;
    Bytes.set v.flat k 'n';
    narrow
  end

let wide_of v k =
  let wide = v.wide.(k) in
  if Array1.dim wide > 0 then wide
  else begin
    let wide = Spill.int32s span in
    let base = v.base.(k) and narrow = v.narrow.(k) in
    if Array1.dim narrow = 0 then Array1.fill wide (Int32.of_int base)
    else for i = 0 to span - 1 do wide.{i} <- Int32.of_int (base + narrow.{i}) done;
    v.wide.(k) <- wide;
    v.narrow.(k) <- no_narrow;
    Bytes.set v.flat k 'n';
    wide
  end

let set v i x =
  check v i;
  if not (fits x) then Scc_base.Bug.fail __POS__ "a number that is too great";
  let k = i lsr bits and at = i land (span - 1) in
  let base = v.base.(k) in
  if Array1.dim v.wide.(k) > 0 || not (is_near (x - base)) then Array1.set (wide_of v k) at (Int32.of_int x)
  else if Array1.dim v.narrow.(k) > 0 || x <> base then Array1.set (narrow_of v k) at (x - base)

let make_room v x =
  let k = v.length lsr bits in
  if k = Array.length v.base then begin
    let more = Int.max 8 k in
    v.wide <- Array.append v.wide (Array.make more no_wide);
    v.narrow <- Array.append v.narrow (Array.make more no_narrow);
    v.base <- Array.append v.base (Array.make more 0);
    v.flat <- Bytes.cat v.flat (Bytes.make more 'y')
  end;
  v.base.(k) <- x

(* Mostly it is near the base, as those before it are. *)
let push v x =
  let i = v.length in
  let k = i lsr bits and at = i land (span - 1) in
  if at = 0 then make_room v x;
  v.length <- i + 1;
  let near = x - Array.unsafe_get v.base k in
  if is_flat v k then begin if near <> 0 || at = 0 then set v i x end
  else
    let narrow : narrow = Array.unsafe_get v.narrow k in
    if Array1.dim narrow > 0 && is_near near then Array1.unsafe_set narrow at near else set v i x

let bytes v =
  let chunks = 24 * Array.length v.base in
  let wide = Array.fold_left (fun n cells -> n + (4 * Array1.dim cells)) chunks v.wide in
  Array.fold_left (fun n cells -> n + (2 * Array1.dim cells)) wide v.narrow
