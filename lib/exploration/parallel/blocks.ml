type t = {
  log : Log.t;
  full : int;  (** bytes of a block *)
  buffer : Buffer.t;
  begun : float;
  mutable written : float;  (** when, the last block *)
  mutable took : float;  (** seconds, to write it *)
  mutable looked : float;  (** when, at the clock *)
  mutable since : int;  (** how many have been added since then *)
  mutable words : float;  (** that had been allocated by then *)
  mutable quick : bool;  (** before that they came one soon after the other *)
}

(* Seconds after which a block is written that is not full: so many that writing takes a thirtieth of the time,
   unless that is more than a second. *)
let patience b now =
  Float.min 1. (Float.max 0.02 (Float.max ((now -. b.begun) /. 20.) (30. *. b.took)))

let make ?(full = 1 lsl 20) log =
  let now = Unix.gettimeofday () in
  let buffer = Buffer.create 65536 in
  { log; full; buffer; begun = now; written = now; took = 0.; looked = now; since = 0; words = 0.; quick = false }

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

(* A look at the clock takes a fiftieth of the time of a quick state: one for so many will do, as long as they are
   quick. What takes long allocates much. *)
let one_of = 16
let soon = 20e-6
let much = 1e5

let is_time b =
  b.since <- b.since + 1;
  (b.since >= one_of || (not b.quick) || Gc.minor_words () -. b.words > much)
  &&
  let now = Unix.gettimeofday () in
  b.quick <- now -. b.looked < soon *. float_of_int b.since;
  b.looked <- now;
  b.since <- 0;
  b.words <- Gc.minor_words ();
  now -. b.written > patience b now

let add b put =
  put b.buffer;
  if Buffer.length b.buffer >= b.full || is_time b then write b
