open Scc_base

(* An alarm for each request would cost more than many of them: one rings at short intervals while there is work,
   and counts. *)
let interval = 0.05

exception Given_up of Scc_oracle.Fault.stop

type t = {
  words : int;  (** the heap may have so many *)
  mutable active : bool;  (** within [bounded] *)
  mutable since : float;  (** how long, by the alarm *)
  mutable seconds : float;
}

let ring t _ =
  if t.active then begin
    t.since <- t.since +. interval;
    if t.since > t.seconds then raise (Given_up Seconds);
    if Memory.heap_words () > t.words then raise (Given_up Memory)
  end

let create ~memory_mib =
  let words = Memory.words_of_mib memory_mib in
  let t = { words; active = false; since = 0.; seconds = infinity } in
  Sys.set_signal Sys.sigalrm (Sys.Signal_handle (ring t));
  t

let timer seconds = ignore (Unix.setitimer ITIMER_REAL { it_interval = seconds; it_value = seconds })

let working t f =
  timer interval;
  Fun.protect f ~finally:(fun () ->
      t.active <- false;
      timer 0.)

let bounded t ~seconds f =
  t.since <- 0.;
  t.seconds <- seconds;
  match
    t.active <- true;
    let x = f () in
    t.active <- false;
    x
  with
  | x -> Ok x
  | exception Given_up stop ->
    t.active <- false;
    (match stop with Memory -> Scc_system.Garbage.compact () | Seconds -> ());
    Error stop
  | exception e ->
    t.active <- false;
    raise e
