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

(* Reasons are kept as digits, and faults beside them. *)
type 'fault t = { mutable marks : Bytes.t; faults : (int, 'fault) Hashtbl.t }

let create () = { marks = Bytes.make 1024 'q'; faults = Hashtbl.create 1 }

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

let get s i =
  match Bytes.get s.marks i with
  | 'q' -> Queued
  | 'e' -> Expanded
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

let set s i status =
  (match status with
   | Unexpanded (Fault f) -> Hashtbl.replace s.faults i f
   | Expanded | Queued | Unexpanded _ -> ());
  if i >= Bytes.length s.marks then begin
    let marks = Bytes.make (2 * i) 'q' in
    Bytes.blit s.marks 0 marks 0 (Bytes.length s.marks);
    s.marks <- marks
  end;
  Bytes.set s.marks i (mark status)

let is_expanded s i = Char.equal (Bytes.get s.marks i) 'e'
let bytes s = Bytes.length s.marks
