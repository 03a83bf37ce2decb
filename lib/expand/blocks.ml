type t = {
  log : Log.t;
  full : int;  (** bytes of a block *)
  buffer : Buffer.t;
  begun : float;
  mutable written : float;  (** when, the last block *)
  mutable took : float;  (** seconds, to write it *)
}

(* Seconds after which a block is written that is not full: so many that writing takes a thirtieth of the time,
   unless that is more than a second. *)
let patience b now =
  Float.min 1. (Float.max 0.02 (Float.max ((now -. b.begun) /. 20.) (30. *. b.took)))

let make ?(full = 1 lsl 20) log =
  let now = Unix.gettimeofday () in
  { log; full; buffer = Buffer.create 65536; begun = now; written = now; took = 0. }

let is_empty b = Buffer.length b.buffer = 0

let write b =
  if not (is_empty b) then begin
    let started = Unix.gettimeofday () in
    let block = Buffer.contents b.buffer in
    Buffer.clear b.buffer;
    b.log.keep block;
    b.written <- Unix.gettimeofday ();
    b.took <- b.written -. started
  end

let is_time b =
  let now = Unix.gettimeofday () in
  now -. b.written > patience b now

let add b put =
  put b.buffer;
  if Buffer.length b.buffer >= b.full || is_time b then write b
