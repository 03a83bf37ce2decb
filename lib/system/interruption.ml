exception Interrupted of string

let signals = [ Sys.sigint; Sys.sigterm; Sys.sighup; Sys.sigxcpu ]
let interrupted = Interrupted "interrupted"

type answer =
  | Nobody
  | Somebody of (unit -> unit)
  | Nobody_since of { time : float; patience : float }

(* Signals are those of a process, and so is what is known of them. *)
let answer = ref Nobody
let first = ref infinity
let waiting = ref 0
let held = ref 0
let due = ref false

(* Seconds in which one wish to stop may arrive twice, sent to the program and to its group of processes. *)
let again = 0.5

let heard () = !first < infinity

let end_by signal =
  Sys.set_signal signal Sys.Signal_default;
  Unix.kill (Unix.getpid ()) signal

let raise_unless_held () = if !held > 0 then due := true else raise interrupted

let arrived signal =
  let now = Unix.gettimeofday () in
  if heard () then (if now -. !first > again && signal <> Sys.sigxcpu then end_by signal)
  else begin
    let is_late = match !answer with Nobody_since { time; patience } -> now -. time > patience | _ -> true in
    first := now;
    match !answer with
    | Somebody react ->
      react ();
      if !waiting > 0 then raise_unless_held ()
    | Nobody | Nobody_since _ -> if is_late || !waiting > 0 then raise_unless_held ()
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

let answered react =
  listen ();
  answer := Somebody react

let unanswered ~patience = answer := Nobody_since { time = Unix.gettimeofday (); patience }

let within count f =
  incr count;
  Fun.protect f ~finally:(fun () -> decr count)

let at_once f =
  within waiting (fun () ->
      if heard () then raise interrupted;
      f ())

let expire why = if !waiting > 0 && !held = 0 then raise (Interrupted why)

let unbroken f =
  let x = within held f in
  if !due && !held = 0 then raise interrupted;
  x

let set behaviour = List.iter (fun s -> Sys.set_signal s behaviour)
let ignored () = if not Sys.win32 then set Sys.Signal_ignore signals

let leave_to_parent () =
  answer := Somebody ignore;
  waiting := 0;
  set Sys.Signal_ignore [ Sys.sigint; Sys.sighup ];
  set Sys.Signal_default [ Sys.sigterm; Sys.sigxcpu ]

(* No handler of this process is ever called in the other one. *)
let fork work =
  let before = Unix.sigprocmask SIG_BLOCK (Sys.sigalrm :: signals) in
  let unblock () = ignore (Unix.sigprocmask SIG_SETMASK before) in
  match Unix.fork () with
  | 0 ->
    leave_to_parent ();
    Sys.set_signal Sys.sigalrm Sys.Signal_default;
    unblock ();
    work ()
  | pid ->
    unblock ();
    pid
  | exception e ->
    unblock ();
    raise e
