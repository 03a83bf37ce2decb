open Bigarray
open Scc_data

type wide = (int, int_elt, c_layout) Array1.t
type narrow = (int32, int32_elt, c_layout) Array1.t
type index = (int32, int32_elt, c_layout) Array1.t

(* A pair is one key of 62 bits; the keys are kept in chunks, in the order of their numbers: narrow ones, of 32
   bits for each, where all numbers are less than 2^16, and wide ones. The index is an open hash table, probed line
   by line. Of the 32 bits of a key's hash, the upper ones are its slot, and the others stand in the slot beside
   the number: hardly any key is read that is not the one that is looked for. *)
type t = {
  mutable narrow : narrow array;  (** empty where the chunk is wide *)
  mutable wide : wide array;
  mutable size : int;
  mutable index : index;
  mutable bits : int;  (** the index has 2^bits slots *)
  in_files : bool;  (** tables may be made there ({!Spill}) *)
}

let chunk_bits = 13
let chunk = 1 lsl chunk_bits
let half = 31
let mask = (1 lsl half) - 1

let int32s ~in_files count = if in_files then Spill.int32s count else Array1.create int32 c_layout count
let ints ~in_files count = if in_files then Spill.ints count else Array1.create int c_layout count

let word = 32

(* No slot that is taken: at most four fifths are, and so no number has all of its bits set. *)
let free = -1

let make_index ~in_files bits : index =
  let index = int32s ~in_files (1 lsl bits) in
  Array1.fill index (-1l);
  index

let first_bits = 8

let no_narrow : narrow = Array1.create int32 c_layout 0
let no_wide : wide = Array1.create int c_layout 0

let create ~in_files =
  { narrow = [||]; wide = [||]; size = 0; index = make_index ~in_files first_bits; bits = first_bits; in_files }

let size p = p.size

let quarter = 16
let small = (1 lsl quarter) - 1
let is_narrow k = (k lsr half) lor (k land mask) <= small
let[@inline] narrowed k = Int32.of_int (((k lsr half) lsl quarter) lor (k land small))

let[@inline] widened x =
  let x = Int32.to_int x in
  (((x lsr quarter) land small) lsl half) lor (x land small)

let[@inline] key p i : int =
  let narrow : narrow = Array.unsafe_get p.narrow (i lsr chunk_bits) in
  if Array1.dim narrow > 0 then widened (Array1.unsafe_get narrow (i land (chunk - 1)))
  else
    let wide : wide = Array.unsafe_get p.wide (i lsr chunk_bits) in
    Array1.unsafe_get wide (i land (chunk - 1))

let check p i = if i < 0 || i >= p.size then Scc_base.Bug.fail __POS__ "an index out of range"

let unpack_left k = k lsr half
let unpack_right k = k land mask

let left p i =
  check p i;
  unpack_left (key p i)

let right p i =
  check p i;
  unpack_right (key p i)

(* As many slots as a line of a processor's cache holds. Pairs that are alike but for the lowest bits of what is on
   the right are looked for in one line, each in another of its slots, as such pairs are often asked for one after
   the other. *)
let line = 16

(* Fibonacci hashing: the upper bits of a product, after the upper half has been mixed into the lower. *)
let[@inline] hash k =
  let alike = k land lnot (line - 1) in
  ((alike lxor (alike lsr 29)) * 0x1E3779B97F4A7C15) lsr (Sys.int_size - word)

let[@inline] slot k h bits = ((h lsr (word - bits)) land lnot (line - 1)) lor ((h + k) land (line - 1))

(* From a slot the way leads to the same one of the next line, and after all lines to the next slot of the
   first. *)
let[@inline] next (index : index) i =
  let j = i + line in
  if j < Array1.dim index then j else (i + 1) land (line - 1)

(* What a slot holds is read with its sign, and so is the tag, which is what is above the number. *)
let[@inline] tag h bits = (h lsl (Sys.int_size - word + bits)) asr (Sys.int_size - word + bits)
let[@inline] entry (index : index) i = Int32.to_int (Array1.unsafe_get index i)
let[@inline] number e bits = e land ((1 lsl bits) - 1)

(* The first slot from this one on that is free, or has the tag. *)
let rec candidate (index : index) bits tag i =
  let e = entry index i in
  if e = free || e asr bits = tag then i else candidate index bits tag (next index i)

(* The number of the key; or, of one that is not there, the complement of the slot where it belongs. *)
let rec probe p k tag i =
  let i = candidate p.index p.bits tag i in
  let e = entry p.index i in
  if e = free then lnot i
  else
    let id = number e p.bits in
    if key p id = k then id else probe p k tag (next p.index i)

let look p k =
  let h = hash k in
  probe p k (tag h p.bits) (slot k h p.bits)

let enter (index : index) bits i h id =
  Array1.unsafe_set index i (Int32.of_int ((tag h bits lsl bits) lor id))

(* An index is made of the keys alone: of a large one there is only one at a time. *)
let large = 1 lsl 22

let enlarge p =
  if Array1.dim p.index >= large then begin
    p.index <- make_index ~in_files:false 0;
    Gc.full_major ()
  end;
  let bits = p.bits + 1 in
  let index = make_index ~in_files:p.in_files bits in
  let rec vacant i = if entry index i = free then i else vacant (next index i) in
  for id = 0 to p.size - 1 do
    let k = key p id in
    let h = hash k in
    enter index bits (vacant (slot k h bits)) h id
  done;
  p.bits <- bits;
  p.index <- index

let make_room p c =
  if c = Array.length p.narrow then begin
    let more = Int.max 8 c in
    p.narrow <- Array.append p.narrow (Array.make more no_narrow);
    p.wide <- Array.append p.wide (Array.make more no_wide)
  end;
  p.narrow.(c) <- int32s ~in_files:p.in_files chunk

let widen p c =
  let narrow = p.narrow.(c) in
  let wide = ints ~in_files:p.in_files chunk in
  for i = 0 to chunk - 1 do wide.{i} <- widened narrow.{i} done;
  p.wide.(c) <- wide;
  p.narrow.(c) <- no_narrow

let put p id k =
  let c = id lsr chunk_bits and at = id land (chunk - 1) in
  if at = 0 then make_room p c;
  if Array1.dim p.narrow.(c) > 0 && not (is_narrow k) then widen p c;
  if Array1.dim p.narrow.(c) > 0 then p.narrow.(c).{at} <- narrowed k else p.wide.(c).{at} <- k

let add p k i =
  let id = p.size in
  if id > mask then Scc_base.Bug.fail __POS__ "more than 2^31 pairs";
  put p id k;
  p.size <- id + 1;
  enter p.index p.bits i (hash k) id;
  (* At most four fifths of the slots are taken. *)
  if 5 * p.size > 4 * Array1.dim p.index then enlarge p;
  id

let[@inline] pack l r =
  if (l lor r) land lnot mask <> 0 then Scc_base.Bug.fail __POS__ "a number that is too great";
  (l lsl half) lor r

let intern_key p k =
  let id = look p k in
  if id >= 0 then id
  else begin
    Scc_base.Critical.enter ();
    let id = add p k (lnot id) in
    Scc_base.Critical.leave ();
    id
  end

let find_key p k = Int.max (-1) (look p k)
let intern p l r = intern_key p (pack l r)
let find p l r = find_key p (pack l r)

(* The loads of the first loop do not wait for each other, as they do when each key is looked up by itself. *)
let find_keys p (keys : int array) (ids : int array) count =
  let index = p.index and bits = p.bits in
  let numbers = (1 lsl bits) - 1 in
  for n = 0 to count - 1 do
    let k = Array.unsafe_get keys n in
    Array.unsafe_set ids n (entry index (slot k (hash k) bits))
  done;
  for n = 0 to count - 1 do
    let k = Array.unsafe_get keys n and e = Array.unsafe_get ids n in
    let id = e land numbers in
    Array.unsafe_set ids n
      (if e = free then -1
       else if e asr bits = tag (hash k) bits && key p id = k then id
       else find_key p k)
  done

let bytes p =
  let narrow = Array.fold_left (fun n cells -> n + (4 * Array1.dim cells)) (4 * Array1.dim p.index) p.narrow in
  Array.fold_left (fun n cells -> n + (8 * Array1.dim cells)) narrow p.wide
