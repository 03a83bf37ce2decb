open Scc_shared

type t = {
  labels : Shared_memory.numbers;  (** of each state: its depth and the number of its arrival *)
  header : Shared_memory.numbers;
  known : Shared_memory.bytes;  (** labels that the process with the graph knows *)
  recent : recent array;  (** of each process: by place, what it has told lately of tuples without a number *)
}

and recent = {
  mutable key : int;
  mutable flags : int;
  mutable from : int;  (** what is in [labels] of the state that leads there; -1 if that is not to be used *)
  mutable way : int;
  mutable version : int;
}

let half = 31
let mask = (1 lsl half) - 1
let most_labels = 1 lsl 27
let recent_bits = 13
let recent = 1 lsl recent_bits

let create () =
  match (Shared_memory.many_numbers (), Shared_memory.numbers 2, Shared_memory.bytes most_labels) with
  | Some labels, Some header, Some known -> Some { labels; header; known; recent = Array.init recent (fun _ -> { key = -1; flags = 0; from = -1; way = 0; version = 0 }) }
  | _ -> None

let put t i ~depth ~arrival =
  if i >= Bigarray.Array1.dim t.labels then raise (Limits.Over Memory);
  Bigarray.Array1.unsafe_set t.labels i ((depth lsl half) lor arrival)

let[@inline] depth t i = Bigarray.Array1.unsafe_get t.labels i lsr half
let[@inline] arrival t i = Bigarray.Array1.unsafe_get t.labels i land mask
let version t = Shared_memory.read t.header 0
let may_turn t = Shared_memory.read t.header 1 <> 0
let note_turn t = Shared_memory.write t.header 1 1
let improved t = ignore (Shared_memory.add t.header 0 1)
let[@inline] knows_label t label = label < most_labels && Bigarray.Array1.unsafe_get t.known label <> 0
let note_label t label = if label < most_labels then Bigarray.Array1.unsafe_set t.known label 1

let[@inline] recent t key = Array.unsafe_get t.recent ((key * 0x1E3779B97F4A7C15) lsr (Sys.int_size - recent_bits))

let has_told t key ~from ~way =
  let r = recent t key in
  r.key = key && r.way = way && r.from = Bigarray.Array1.unsafe_get t.labels from && r.version = version t

let flags t key =
  let r = recent t key in
  if r.key = key then r.flags else -1

let tell t key flags ~from ~way ~told =
  let r = recent t key in
  r.key <- key;
  r.flags <- flags;
  r.from <- (if told then Bigarray.Array1.unsafe_get t.labels from else -1);
  r.way <- way;
  r.version <- version t

let bytes t ~states = 8 * Int.min states (Bigarray.Array1.dim t.labels)

