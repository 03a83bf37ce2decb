let grace = 3.

(* Nothing is flushed: what was printed so far may be half of a report. *)
let give_up why =
  prerr_endline ("scc: " ^ why ^ ", and the step that was under way did not end");
  flush stderr;
  Unix._exit (Scc_session.Exit_code.to_int Stopped)

exception Given_up

(* Signals are the program's, and so is what to do about them. *)
type state = {
  mutable attempting : bool;
  mutable over : bool;  (** the time, or after a signal *)
  mutable reporting : bool;  (** an exploration is over, and what it found is looked over *)
}

let state = { attempting = false; over = false; reporting = false }
let timer seconds = ignore (Unix.setitimer ITIMER_REAL { it_interval = 0.; it_value = seconds })

let alarm ?(explores = false) seconds why =
  let ring _ =
    if state.attempting then raise Given_up
    else if explores && state.reporting then timer grace
    else give_up why
  in
  Sys.set_signal Sys.sigalrm (Sys.Signal_handle ring);
  timer seconds

let in_time () =
  state.over <- true;
  timer 0.

let attempted f =
  state.attempting <- true;
  match
    if state.over then alarm grace "the time is over";
    let x = f () in
    (* Before the alarm could ring for somebody else. *)
    if state.over then timer 0.;
    x
  with
  | x ->
    state.attempting <- false;
    Some x
  | exception Given_up ->
    state.attempting <- false;
    None
  | exception e ->
    state.attempting <- false;
    raise e

let attempt = { Scc_explore.Limits.run = attempted }

let ended () = state.reporting <- true

(* A timer takes no more than a machine's integer; nobody waits for years. *)
let limit ~explores seconds =
  if seconds < 1e8 then alarm ~explores (seconds +. grace) "the limit of seconds has passed"

let deadline seconds = limit ~explores:false seconds

(* Who looks at the clock and sees that the time is over, stops by itself. *)
let clock seconds =
  let stop = Unix.gettimeofday () +. seconds in
  (* Of an earlier limit, or after a signal: that is asked for anew. *)
  state.over <- false;
  limit ~explores:true seconds;
  fun () ->
    let now = Unix.gettimeofday () in
    state.reporting <- false;
    if now >= stop then in_time ();
    now

let install () =
  let arrived = ref false in
  let handle _ =
    arrived := true;
    Sys.set_signal Sys.sigint Sys.Signal_default;
    Sys.set_signal Sys.sigterm Sys.Signal_default;
    alarm grace "interrupted"
  in
  Sys.set_signal Sys.sigint (Sys.Signal_handle handle);
  Sys.set_signal Sys.sigterm (Sys.Signal_handle handle);
  fun () ->
    if !arrived then in_time ();
    !arrived
