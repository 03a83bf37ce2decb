open Bigarray

type int32s = (int32, int32_elt, c_layout) Array1.t

(* Fingerprints are kept in chunks in the order of their numbers, four words each. The index is an open hash table
   of numbers, with -1 in free slots and linear probing. A fingerprint is a sum of digests: any word of it will do
   as a hash, and it is not the first one, by which owners are told apart. *)
type t = { mutable chunks : int32s array; mutable size : int; mutable index : int32s }

let chunk_bits = 13
let chunk = 1 lsl chunk_bits
let most = (1 lsl 31) - 1

let no_chunk : int32s = Array1.create int32 c_layout 0

let make_index slots : int32s =
  let index = Array1.create int32 c_layout slots in
  Array1.fill index (-1l);
  index

let least_slots = 1 lsl 8
let create () = { chunks = [||]; size = 0; index = make_index least_slots }
let size t = t.size
let[@inline] word (c : int32s) at = Int32.to_int (Array1.unsafe_get c at) land 0xFFFF_FFFF

let same t id (print : Keys.fingerprint) =
  let c = Array.unsafe_get t.chunks (id lsr chunk_bits) and at = 4 * (id land (chunk - 1)) in
  word c at = Array.unsafe_get print 0
  && word c (at + 1) = Array.unsafe_get print 1
  && word c (at + 2) = Array.unsafe_get print 2
  && word c (at + 3) = Array.unsafe_get print 3

(* The slot that has it, or the free one where it belongs. *)
let rec probe t (index : int32s) print i =
  let id = Int32.to_int (Array1.unsafe_get index i) in
  if id < 0 || same t id print then i else probe t index print ((i + 1) land (Array1.dim index - 1))

let[@inline] slot (index : int32s) hash = hash land (Array1.dim index - 1)

(* Into an index of free slots. *)
let put_all t index =
  let rec free i = if Int32.to_int (Array1.unsafe_get index i) < 0 then i else free (slot index (i + 1)) in
  for id = 0 to t.size - 1 do
    let c = t.chunks.(id lsr chunk_bits) in
    index.{free (slot index (word c ((4 * (id land (chunk - 1))) + 1)))} <- Int32.of_int id
  done;
  t.index <- index

let enlarge t =
  let slots = 2 * Array1.dim t.index in
  t.index <- no_chunk;
  put_all t (make_index slots)

let add t (print : Keys.fingerprint) i =
  let id = t.size in
  if id >= most then Scc_base.Bug.fail __POS__ "more than 2^31 fingerprints";
  let k = id lsr chunk_bits and at = 4 * (id land (chunk - 1)) in
  if k = Array.length t.chunks then t.chunks <- Array.append t.chunks (Array.make (Int.max 8 k) no_chunk);
  if Array1.dim t.chunks.(k) = 0 then t.chunks.(k) <- Array1.create int32 c_layout (4 * chunk);
  let c = t.chunks.(k) in
  for w = 0 to 3 do c.{at + w} <- Int32.of_int print.(w) done;
  t.index.{i} <- Int32.of_int id;
  t.size <- id + 1;
  (* At most four fifths of the slots are taken. *)
  if 5 * t.size > 4 * Array1.dim t.index then enlarge t;
  id

let intern t print =
  if Array.length print <> Keys.words then invalid_arg "Prints.intern";
  let i = probe t t.index print (slot t.index print.(1)) in
  let id = Int32.to_int (Array1.unsafe_get t.index i) in
  if id >= 0 then id else add t print i

let cut t size =
  if size < t.size then begin
    t.size <- size;
    for k = (size + chunk - 1) lsr chunk_bits to Array.length t.chunks - 1 do
      t.chunks.(k) <- no_chunk
    done;
    if size = 0 then t.index <- make_index least_slots
    else begin
      Array1.fill t.index (-1l);
      put_all t t.index
    end
  end

let bytes t = Array.fold_left (fun n c -> n + (4 * Array1.dim c)) (4 * Array1.dim t.index) t.chunks
