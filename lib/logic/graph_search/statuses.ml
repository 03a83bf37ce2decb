type 'fault reason =
  | Depth
  | Time
  | Instant
  | States
  | Bits
  | Seconds
  | Memory
  | Interrupted
  | Stopped
  | Fault of 'fault

let of_stop : Limits.stop -> 'fault reason = function
  | Seconds -> Seconds
  | Memory -> Memory
  | Interrupted -> Interrupted

type 'fault status = Expanded | Queued | Unexpanded of 'fault reason

(* Reasons are kept as digits, and faults beside them: in chunks of [span], of which one whose marks are all
   equal has none, but stands for its common one. *)
type 'fault t = {
  mutable chunks : Bytes.t array;
  mutable common : Bytes.t;
  faults : (int, 'fault) Hashtbl.t;
  counts : int array;  (** how many have each mark; not of ['q'], which all have before they are set *)
}

let bits = 12
let span = 1 lsl bits
let create () = { chunks = [||]; common = Bytes.empty; faults = Hashtbl.create 1; counts = Array.make 256 0 }

let mark = function
  | Queued -> 'q'
  | Expanded -> 'e'
  | Unexpanded Depth -> '0'
  | Unexpanded Time -> '1'
  | Unexpanded Instant -> '2'
  | Unexpanded States -> '3'
  | Unexpanded Seconds -> '4'
  | Unexpanded Memory -> '5'
  | Unexpanded Interrupted -> '6'
  | Unexpanded Stopped -> '7'
  | Unexpanded (Fault _) -> '8'
  | Unexpanded Bits -> '9'

let mark_at s i =
  let k = i lsr bits in
  let chunk = s.chunks.(k) in
  if Bytes.length chunk > 0 then Bytes.unsafe_get chunk (i land (span - 1)) else Bytes.get s.common k

let get s i =
  match mark_at s i with
  | 'q' -> Queued
  | 'e' | 't' | 'r' -> Expanded
  | '0' -> Unexpanded Depth
  | '1' -> Unexpanded Time
  | '2' -> Unexpanded Instant
  | '3' -> Unexpanded States
  | '4' -> Unexpanded Seconds
  | '5' -> Unexpanded Memory
  | '6' -> Unexpanded Interrupted
  | '7' -> Unexpanded Stopped
  | '9' -> Unexpanded Bits
  | '8' -> Unexpanded (Fault (Hashtbl.find s.faults i))
  | _ -> Scc_base.Bug.fail __POS__ "no status"

let make_room s k =
  let known = Array.length s.chunks in
  if k >= known then begin
    let more = Int.max 8 (k + 1 - known + (known / 2)) in
    s.chunks <- Array.append s.chunks (Array.make more Bytes.empty);
    s.common <- Bytes.cat s.common (Bytes.make more 'q')
  end

let are_equal chunk =
  let first = Bytes.unsafe_get chunk 0 in
  let rec from i = i = span || (Char.equal first (Bytes.unsafe_get chunk i) && from (i + 1)) in
  from 1

let count_as s mark by =
  let k = Char.code mark in
  s.counts.(k) <- s.counts.(k) + by

let put s i mark =
  let k = i lsr bits and at = i land (span - 1) in
  make_room s k;
  let before = mark_at s i in
  if not (Char.equal before mark) then begin
    count_as s before (-1);
    count_as s mark 1
  end;
  if Bytes.length s.chunks.(k) > 0 || not (Char.equal (Bytes.get s.common k) mark) then begin
    if Bytes.length s.chunks.(k) = 0 then s.chunks.(k) <- Bytes.make span (Bytes.get s.common k);
    let chunk = s.chunks.(k) in
    Bytes.unsafe_set chunk at mark;
    (* States are mostly expanded in their order, and end alike. *)
    if at = span - 1 && are_equal chunk then begin
      Bytes.set s.common k mark;
      s.chunks.(k) <- Bytes.empty
    end
  end

let set s i status =
  (match status with
   | Unexpanded (Fault f) -> Hashtbl.replace s.faults i f
   | Expanded | Queued | Unexpanded _ -> ());
  put s i (mark status)

let count s reason = s.counts.(Char.code (mark (Unexpanded reason)))

(* The reasons have the ten digits. *)
let unexpanded s =
  let rec from k sum = if k > Char.code '9' then sum else from (k + 1) (sum + Array.unsafe_get s.counts k) in
  from (Char.code '0') 0

let is_expanded s i = match mark_at s i with 'e' | 't' | 'r' -> true | _ -> false

let note_timed s i = put s i 't'
let is_timed s i = Char.equal (mark_at s i) 't'
let note_reduced s i = put s i 'r'
let is_reduced s i = Char.equal (mark_at s i) 'r'
let bytes s = Array.fold_left (fun n chunk -> n + 8 + Bytes.length chunk) (Bytes.length s.common) s.chunks
