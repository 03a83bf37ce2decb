open Scc_base

exception Interrupted of string

let signals = [ Sys.sigint; Sys.sigterm; Sys.sighup; Sys.sigxcpu ]
let interrupted = Interrupted "interrupted"

(* Signals are those of a process, and so is what is known of them. *)
let answer = ref None
let first = ref infinity
let waiting = ref 0
let due = ref false

(* It is due, and has not been raised yet. *)
let pending = ref false

(* Seconds in which one wish to stop may arrive twice, sent to the program and to its group of processes. *)
let again = 0.5

let heard () = !first < infinity

let end_by signal =
  Sys.set_signal signal Sys.Signal_default;
  Unix.kill (Unix.getpid ()) signal

let check () =
  if !due then begin
    pending := false;
    raise interrupted
  end

(* Seconds of work from one try to the next. *)
let retry = 0.001

let rec break_off () =
  due := true;
  pending := Critical.active ();
  if !pending then begin
    Sys.set_signal Sys.sigvtalrm (Signal_handle (fun _ -> break_off ()));
    ignore (Unix.setitimer ITIMER_VIRTUAL { it_interval = 0.; it_value = retry })
  end
  else check ()

let arrived signal =
  let now = Unix.gettimeofday () in
  if heard () then (if now -. !first > again && signal <> Sys.sigxcpu then end_by signal)
  else begin
    first := now;
    Option.iter (fun react -> react ()) !answer;
    if Option.is_none !answer || !waiting > 0 then break_off ()
  end

let listening = ref false

let listen () =
  if not !listening then begin
    listening := true;
    let handle = Sys.Signal_handle arrived in
    let hear s =
      match Sys.signal s handle with
      | Sys.Signal_ignore when s = Sys.sighup -> Sys.set_signal s Sys.Signal_ignore
      | _ -> ()
    in
    if not Sys.win32 then List.iter hear signals
  end

external heed : unit -> unit = "scc_heed_signals"

let answered react =
  listen ();
  answer := Some react

let settle () =
  answered ignore;
  if !pending then check ()

let at_once f =
  incr waiting;
  Fun.protect
    ~finally:(fun () -> decr waiting)
    (fun () ->
       if heard () then raise interrupted;
       f ())

let expire why = if !waiting > 0 && not (Critical.active ()) then raise (Interrupted why)

let set behaviour = List.iter (fun s -> Sys.set_signal s behaviour)
let ignored () = if not Sys.win32 then set Sys.Signal_ignore signals

(* A terminal sends SIGINT and SIGHUP to the parent as well; SIGTERM and SIGXCPU end this process at once. *)
let leave_to_parent () =
  answer := Some ignore;
  due := false;
  pending := false;
  waiting := 0;
  set Sys.Signal_ignore [ Sys.sigint; Sys.sighup ];
  set Sys.Signal_default [ Sys.sigterm; Sys.sigxcpu ]

let request = Sys.sigusr1

(* Seconds in which work ends by itself after a request of the parent, before it is broken off. *)
let gentle = 0.2

(* A signal to all processes of the program reaches the parent, which requests what it wants. *)
let leave_requests_to_parent () =
  let parent = Unix.getppid () in
  let requested _ =
    if not (heard ()) then begin
      first := Unix.gettimeofday ();
      ignore (Unix.setitimer ITIMER_REAL { it_interval = 0.; it_value = gentle })
    end
  in
  Sys.set_signal Sys.sigalrm (Signal_handle (fun _ -> if !waiting > 0 then break_off ()));
  Sys.set_signal Sys.sigterm (Signal_handle (fun s -> if Unix.getppid () <> parent then end_by s));
  Sys.set_signal request (Signal_handle requested)

(* No handler of this process is ever called in the other one. *)
let fork ?(obedient = false) work =
  let before = Unix.sigprocmask SIG_BLOCK (request :: Sys.sigalrm :: signals) in
  let unblock () = ignore (Unix.sigprocmask SIG_SETMASK before) in
  match Unix.fork () with
  | 0 ->
    leave_to_parent ();
    Sys.set_signal Sys.sigalrm Sys.Signal_default;
    if obedient then leave_requests_to_parent ();
    unblock ();
    work ()
  | pid ->
    unblock ();
    pid
  | exception e ->
    unblock ();
    raise e
