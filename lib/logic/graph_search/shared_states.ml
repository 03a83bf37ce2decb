open Scc_shared

type t = {
  labels : Shared_memory.numbers;  (** of each state: its depth and the number of its arrival, or {!nothing} *)
  header : Shared_memory.numbers;
  known : Shared_memory.bytes;  (** labels that the process with the graph knows *)
  recent : Shared_memory.numbers;  (** of this process alone: what it has told lately of tuples without a number *)
}

let half = 31
let mask = (1 lsl half) - 1
let most_labels = 1 lsl 27

(* Of what was told lately there are so many rows, by their keys: each of eight numbers, of which it uses five. *)
let recent_bits = 12
let row_bits = 3

let nothing_told () =
  let rows = Bigarray.(Array1.create int c_layout (1 lsl (recent_bits + row_bits))) in
  Bigarray.Array1.fill rows (-1);
  rows

let create () =
  match (Shared_memory.many_numbers (), Shared_memory.numbers 2, Shared_memory.bytes most_labels) with
  | Some labels, Some header, Some known -> Some { labels; header; known; recent = nothing_told () }
  | _ -> None

(* Memory that nobody has written to has zeros. What has been noted of a state is below. *)
type noted = int

let nothing = 0
let is_nothing (noted : noted) = noted = nothing
let[@inline] depth_of (noted : noted) = lnot noted lsr half
let[@inline] arrival_of (noted : noted) = lnot noted land mask
let[@inline] noted t i : noted = Bigarray.Array1.unsafe_get t.labels i

let put t i ~depth ~arrival =
  if i >= Bigarray.Array1.dim t.labels then raise (Limits.Over Memory);
  Bigarray.Array1.unsafe_set t.labels i (lnot ((depth lsl half) lor arrival))

let version t = Shared_memory.read t.header 0
let may_turn t = Shared_memory.read t.header 1 <> 0
let note_turn t = Shared_memory.write t.header 1 1
let improved t = ignore (Shared_memory.add t.header 0 1)
let[@inline] knows_label t label = label < most_labels && Bigarray.Array1.unsafe_get t.known label <> 0
let note_label t label = if label < most_labels then Bigarray.Array1.unsafe_set t.known label 1

(* The places in a row. [from] is what has been noted of the state that leads there, or {!nothing} if that is not
   to be used. *)
let flags_at = 1
let from_at = 2
let way_at = 3
let version_at = 4

let[@inline] row key = ((key * 0x1E3779B97F4A7C15) lsr (Sys.int_size - recent_bits)) lsl row_bits
let[@inline] read (rows : Shared_memory.numbers) at = Bigarray.Array1.unsafe_get rows at
let[@inline] write (rows : Shared_memory.numbers) at number = Bigarray.Array1.unsafe_set rows at number

let has_told t key ~from ~way =
  let rows = t.recent and at = row key in
  read rows at = key
  && read rows (at + way_at) = way
  && read rows (at + from_at) = noted t from
  && read rows (at + version_at) = version t

let flags t key =
  let rows = t.recent and at = row key in
  if read rows at = key then read rows (at + flags_at) else -1

let tell t key flags ~from ~way ~told =
  let rows = t.recent and at = row key in
  write rows at key;
  write rows (at + flags_at) flags;
  write rows (at + from_at) (if told then noted t from else nothing);
  write rows (at + way_at) way;
  write rows (at + version_at) (version t)

let bytes t ~states = 8 * Int.min states (Bigarray.Array1.dim t.labels)

