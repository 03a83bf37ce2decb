open Scc_shared

type t = { mutable bits : Bytes.t; mutable shared : Shared_memory.bytes option }

let create () = { bits = Bytes.empty; shared = None }

let make_room t at =
  if at >= Bytes.length t.bits then begin
    let bits = Bytes.make (Int.max 1024 (2 * (at + 1))) '\000' in
    Bytes.blit t.bits 0 bits 0 (Bytes.length t.bits);
    t.bits <- bits
  end

let note t number =
  match t.shared with
  | Some seen ->
    let is_new = seen.{number} = 0 in
    if is_new then seen.{number} <- 1;
    is_new
  | None ->
    let at = number lsr 3 and bit = 1 lsl (number land 7) in
    make_room t at;
    let byte = Char.code (Bytes.unsafe_get t.bits at) in
    let is_new = byte land bit = 0 in
    if is_new then Bytes.unsafe_set t.bits at (Char.unsafe_chr (byte lor bit));
    is_new

let mem t number =
  match t.shared with
  | Some seen -> seen.{number} <> 0
  | None ->
    let at = number lsr 3 in
    at < Bytes.length t.bits && Char.code (Bytes.get t.bits at) land (1 lsl (number land 7)) <> 0

(* A byte for each number that there may be. *)
let most = 1 lsl 31

let share t =
  match Shared_memory.bytes most with
  | None -> false
  | Some seen ->
    for number = 0 to (8 * Bytes.length t.bits) - 1 do
      if mem t number then seen.{number} <- 1
    done;
    t.shared <- Some seen;
    t.bits <- Bytes.empty;
    true
