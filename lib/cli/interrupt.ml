let grace = 3.

(* Nothing is flushed: what was printed so far may be half of a report. *)
let give_up why =
  prerr_endline ("scc: " ^ why ^ ", and the step that was under way did not end");
  flush stderr;
  Unix._exit (Exit_code.to_int Stopped)

let alarm seconds why =
  Sys.set_signal Sys.sigalrm (Sys.Signal_handle (fun _ -> give_up why));
  ignore (Unix.setitimer ITIMER_REAL { it_interval = 0.; it_value = seconds })

let in_time () = ignore (Unix.setitimer ITIMER_REAL { it_interval = 0.; it_value = 0. })

(* A timer takes no more than a machine's integer; nobody waits for years. *)
let deadline seconds =
  if seconds < 1e8 then alarm (seconds +. grace) "the limit of seconds has passed"

(* Who looks at the clock and sees that the time is over, stops by itself. *)
let clock seconds =
  let stop = Unix.gettimeofday () +. seconds in
  deadline seconds;
  fun () ->
    let now = Unix.gettimeofday () in
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
