type t = {
  log : Log.t;
  full : int;  (** bytes of a block *)
  buffer : Buffer.t;
  begun : float;
  mutable written : float;  (** when, the last block *)
}

(* Seconds after which a block is written that is not full. *)
let patience ~since_beginning = Float.min 1. (Float.max 0.02 (since_beginning /. 20.))

let make ?(full = 1 lsl 20) log =
  let now = Unix.gettimeofday () in
  { log; full; buffer = Buffer.create 65536; begun = now; written = now }

let is_empty b = Buffer.length b.buffer = 0

let write b =
  if not (is_empty b) then begin
    let block = Buffer.contents b.buffer in
    Buffer.clear b.buffer;
    b.log.keep block
  end;
  b.written <- Unix.gettimeofday ()

let is_time b =
  let now = Unix.gettimeofday () in
  now -. b.written > patience ~since_beginning:(now -. b.begun)

let add b put =
  put b.buffer;
  if Buffer.length b.buffer >= b.full || is_time b then write b
