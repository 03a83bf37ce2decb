open Bigarray
open Scc_data
open Scc_shared

type wide = (int, int_elt, c_layout) Array1.t
type narrow = (int32, int32_elt, c_layout) Array1.t
type index = (int32, int32_elt, c_layout) Array1.t

(* A pair is one key of 62 bits; the keys are kept in chunks, in the order of their numbers: narrow ones, of 32
   bits for each, where all numbers are less than 2^16, and wide ones. The index is an open hash table, probed
   line by line. Of the 32 bits of a key's hash, the upper ones are its slot, and the others stand in the slot
   beside the number: hardly any key is read that is not the one that is looked for. *)
type t = {
  mutable flat : wide;  (** all keys, of a table that processes share; no chunks then *)
  mutable narrow : narrow array;  (** empty where the chunk is wide *)
  mutable wide : wide array;
  mutable size : int;
  mutable index : index;
  mutable bits : int;  (** the index has 2^bits slots *)
  in_files : bool;  (** tables may be made there ({!Spill}) *)
  mutable shared : shared option;
}

(* Of each size that it may come to have there is an index from the beginning, as processes that have been forked
   get no more memory that they share. *)
and shared = {
  header : Shared_memory.numbers;
  indexes : index array;  (** by the bits of their sizes *)
  many : bool;  (** all processes insert; else one of them *)
  mutable next : int;  (** of the numbers that this process may give *)
  mutable beyond : int;
  mutable full : unit -> unit;  (** called where no more pairs fit the index; it makes room, or raises *)
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
  let index = make_index ~in_files first_bits in
  { flat = no_wide; narrow = [||]; wide = [||]; size = 0; index; bits = first_bits; in_files; shared = None }

let size p = p.size

let quarter = 16
let small = (1 lsl quarter) - 1
let is_narrow k = (k lsr half) lor (k land mask) <= small
let[@inline] narrowed k = Int32.of_int (((k lsr half) lsl quarter) lor (k land small))

let[@inline] widened x =
  let x = Int32.to_int x in
  (((x lsr quarter) land small) lsl half) lor (x land small)

let[@inline] key p i : int =
  if Array1.dim p.flat > 0 then Array1.unsafe_get p.flat i
  else
    let narrow : narrow = Array.unsafe_get p.narrow (i lsr chunk_bits) in
    if Array1.dim narrow > 0 then widened (Array1.unsafe_get narrow (i land (chunk - 1)))
    else
      let wide : wide = Array.unsafe_get p.wide (i lsr chunk_bits) in
      Array1.unsafe_get wide (i land (chunk - 1))

let unpack_left k = k lsr half
let unpack_right k = k land mask

let checked p i =
  if i < 0 || (i >= p.size && Array1.dim p.flat = 0) then Scc_base.Bug.fail __POS__ "an index out of range";
  key p i

let left p i = unpack_left (checked p i)
let right p i = unpack_right (checked p i)

(* As many slots as a line of a processor's cache holds. Pairs that are alike but for the lowest bits of what is
   on the right are looked for in one line, each in another of its slots, as such pairs are often asked for one
   after the other. *)
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

(* Of a key that is not there yet. *)
let enter_new p (index : index) bits id =
  let rec vacant i = if entry index i = free then i else vacant (next index i) in
  let k = key p id in
  let h = hash k in
  enter index bits (vacant (slot k h bits)) h id

let put_all p (index : index) bits =
  Array1.fill index (Int32.of_int free);
  for id = 0 to p.size - 1 do enter_new p index bits id done

(* An index is made of the keys alone: of a large one there is only one at a time. *)
let large = 1 lsl 22

let enlarge p =
  if Array1.dim p.index >= large then begin
    p.index <- make_index ~in_files:false 0;
    Gc.full_major ()
  end;
  let bits = p.bits + 1 in
  let index = make_index ~in_files:p.in_files bits in
  put_all p index bits;
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

(** {2 Shared tables} *)

(* Places in the header: the first number that no process may give as yet; the bits of the index; 1 where room is
   wanted. *)
let next_number = 0
let index_bits = 1
let wants_room = 2
let header_length = 3

let numbers_at_once = 64

let[@inline] is_crowded ~parts ~of_ used index = of_ * used > parts * Array1.dim index

(* Once the index is four fifths full, a larger one is wanted, and at fifteen sixteenths nobody goes on without.
*)
let want_room s =
  if Shared_memory.read s.header wants_room = 0 then Shared_memory.write s.header wants_room 1

(* Outside of the section in which a pair is added: to make room may take long. *)
let see_to_room p s =
  if s.many && s.next = s.beyond then begin
    let used = Shared_memory.read s.header next_number in
    if is_crowded ~parts:4 ~of_:5 used p.index then want_room s;
    if is_crowded ~parts:15 ~of_:16 (used + (16 * numbers_at_once)) p.index then s.full ()
  end

let number_for p s =
  if s.many && s.next = s.beyond then begin
    s.next <- Shared_memory.add s.header next_number numbers_at_once;
    s.beyond <- s.next + numbers_at_once
  end;
  let id = if s.many then s.next else p.size in
  if (not s.many) && is_crowded ~parts:4 ~of_:5 id p.index then s.full ();
  if id >= Array1.dim p.flat then raise (Limits.Over Memory);
  id

(* The key is written before its number, so that who finds the number finds the key. Where another process has
   put one into the slot meanwhile, it may be the same. *)
let rec put_shared p s k h id i =
  Array1.unsafe_set p.flat id k;
  let e = (tag h p.bits lsl p.bits) lor id in
  if not s.many then begin
    Shared_memory.write_half p.index i e;
    p.size <- id + 1;
    id
  end
  else if Shared_memory.exchange p.index i ~from:free ~into:e then begin
    s.next <- id + 1;
    id
  end
  else match probe p k (tag h p.bits) i with
    | known when known >= 0 -> known
    | vacant -> put_shared p s k h id (lnot vacant)

(* [full] may have put another index in the place of the one in which it was not found. *)
let add_shared p s k =
  let id = number_for p s in
  let h = hash k in
  match probe p k (tag h p.bits) (slot k h p.bits) with
  | known when known >= 0 -> known
  | vacant -> put_shared p s k h id (lnot vacant)

let intern_key p k =
  let id = look p k in
  if id >= 0 then id
  else begin
    match p.shared with
    | None ->
      Scc_base.Critical.enter ();
      let id = add p k (lnot id) in
      Scc_base.Critical.leave ();
      id
    | Some s ->
      see_to_room p s;
      Scc_base.Critical.run (fun () -> add_shared p s k)
  end

let touch p k = entry p.index (slot k (hash k) p.bits)

let refresh p =
  match p.shared with
  | None -> ()
  | Some s ->
    let bits = Shared_memory.read s.header index_bits in
    if bits <> p.bits then begin
      p.index <- s.indexes.(bits);
      p.bits <- bits
    end

let is_room_wanted p =
  match p.shared with Some s -> Shared_memory.read s.header wants_room <> 0 | None -> false

(* Where all have to stop for it, a small index grows by more at once. *)
let small_bits = 20

(* From what is in the old index: of the numbers that processes took, some have no pair. *)
let enlarge_shared p =
  match p.shared with
  | None -> ()
  | Some s ->
    let bits = if p.bits < small_bits then p.bits + 2 else p.bits + 1 in
    if bits >= Array.length s.indexes then raise (Limits.Over Memory);
    let index = s.indexes.(bits) in
    Array1.fill index (Int32.of_int free);
    for i = 0 to Array1.dim p.index - 1 do
      let e = entry p.index i in
      if e <> free then enter_new p index bits (number e p.bits)
    done;
    Shared_memory.write s.header index_bits bits;
    Shared_memory.write s.header wants_room 0;
    refresh p

(* The numbers that the other process may still give are not for this one. *)
let go_on_apart p ~full =
  let apart s =
    s.next <- s.beyond;
    s.full <- full
  in
  Option.iter apart p.shared

let set_full p full = Option.iter (fun s -> s.full <- full) p.shared

let shared_first_bits = 14

let rec bits_of ?(bits = 0) count = if count <= 1 then bits else bits_of ~bits:(bits + 1) (count / 2)

let move_to p header flat indexes ~first ~many =
  for id = 0 to p.size - 1 do flat.{id} <- key p id done;
  let s = { header; indexes; many; next = 0; beyond = 0; full = (fun () -> enlarge_shared p) } in
  put_all p indexes.(first) first;
  header.{next_number} <- p.size;
  header.{index_bits} <- first;
  p.flat <- flat;
  p.narrow <- [||];
  p.wide <- [||];
  p.index <- indexes.(first);
  p.bits <- first;
  p.shared <- Some s

let share p ~many =
  match (Shared_memory.numbers header_length, Shared_memory.many_numbers ()) with
  | Some header, Some flat when p.size < Array1.dim flat -> (
      let first = Int.max shared_first_bits p.bits in
      let index bits = if bits < first then Some p.index else Shared_memory.halves (1 lsl bits) in
      match Shared_memory.all (List.init (1 + bits_of (Array1.dim flat)) index) with
      | None -> false
      | Some indexes ->
        Scc_base.Critical.run (fun () -> move_to p header flat (Array.of_list indexes) ~first ~many);
        true)
  | _ -> false

(* A key that no pair has stands for a number that has none: it was taken by a process that did not use it. *)
let nothing id = (mask lsl half) lor id

let unshare p =
  match p.shared with
  | None -> ()
  | Some s ->
    let count = if s.many then Shared_memory.read s.header next_number else p.size in
    let taken = Bits.create count and flat = p.flat and index = p.index and bits = p.bits in
    for i = 0 to Array1.dim index - 1 do
      let e = entry index i in
      if e <> free then Bits.add taken (number e bits)
    done;
    p.flat <- no_wide;
    p.shared <- None;
    for id = 0 to count - 1 do
      put p id (if Bits.mem taken id then flat.{id} else nothing id)
    done;
    p.size <- count;
    p.index <- make_index ~in_files:p.in_files bits;
    put_all p p.index bits;
    if 5 * p.size > 4 * Array1.dim p.index then enlarge p

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

(* Of a shared table, what has been written to. *)
let used p = match p.shared with Some { many = true; header; _ } -> header.{next_number} | Some _ | None -> p.size

let bytes p =
  let flat = if Array1.dim p.flat > 0 then 8 * used p else 0 in
  let first = flat + (4 * Array1.dim p.index) in
  let narrow = Array.fold_left (fun n cells -> n + (4 * Array1.dim cells)) first p.narrow in
  Array.fold_left (fun n cells -> n + (8 * Array1.dim cells)) narrow p.wide
