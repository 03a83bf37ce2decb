open Scc_base
open Scc_explore

(* Seconds from one look to the next; heaps grow by some ten megabytes in the meantime. *)
let interval = 0.01

(* Seconds of the processor that conclusions have, and half as many that the report has after them; and those
   after which the program ends without one. *)
let grace = 1.
let patience = 3.

(* How much of the memory explorations leave to conclusions. *)
let left_to_conclusions = 0.25

exception Given_up of Limits.stop

type t = {
  clock : unit -> float;
  signals : bool;
  mutable deadline : float;
  memory : float;  (** in bytes *)
  mutable signalled : bool;
  mutable since : float option;  (** the processor's seconds when the time was over, or a signal came *)
  mutable over : Limits.stop option;  (** for what explores *)
  mutable late : Limits.stop option;  (** for what concludes *)
  mutable last : Limits.stop option;  (** for what reports *)
  mutable stage : Limits.stage option;  (** of the attempt that is being made *)
}

let page = 4096.

(* What is in memory, of the heap and of all else but what files have as well, which the system may drop at any
   time; where the system does not tell, the heap alone. *)
let resident () =
  match open_in_bin "/proc/self/statm" with
  | exception Sys_error _ -> float_of_int (Memory.bytes_of_words (Memory.heap_words ()))
  | file ->
    let line = try input_line file with End_of_file | Sys_error _ -> "" in
    close_in_noerr file;
    (match String.split_on_char ' ' line with
     | _ :: resident :: shared :: _ -> page *. (float_of_string resident -. float_of_string shared)
     | _ -> float_of_int (Memory.bytes_of_words (Memory.heap_words ())))

(* Of the addresses that the system gives to a program, which takes more of them than memory: where none are left,
   arithmetic on long numbers would end the program. *)
let address_space () =
  let is_it line = String.length line > 17 && String.equal (String.sub line 0 17) "Max address space" in
  match open_in_bin "/proc/self/limits" with
  | exception Sys_error _ -> infinity
  | file ->
    let rec find () =
      match input_line file with
      | exception (End_of_file | Sys_error _) -> infinity
      | line when is_it line -> (
          let words = List.filter (fun w -> w <> "") (String.split_on_char ' ' line) in
          match List.nth_opt words 3 with
          | Some soft -> Option.value (float_of_string_opt soft) ~default:infinity
          | None -> infinity)
      | _ -> find ()
    in
    let most = find () in
    close_in_noerr file;
    0.6 *. most

(* Seconds of the processor since the time was over: on a busy machine those of the clock say little of the
   work. *)
let passed t =
  let over = t.signalled || t.clock () > t.deadline in
  match t.since with
  | Some since when over -> Sys.time () -. since
  | Some _ | None ->
    t.since <- (if over then Some (Sys.time ()) else None);
    if over then 0. else -1.

(* What is over when so many seconds more, and so much memory, are allowed. *)
let beyond t ~passed ~bytes ~more ~share : Limits.stop option =
  if passed >= more then Some (if t.signalled then Interrupted else Seconds)
  else if bytes > share *. t.memory then Some Memory
  else None

(* Nothing is flushed: what was printed so far may be half of a report. *)
let abandon t =
  let why = if t.signalled then "interrupted" else "the limit of seconds has passed" in
  prerr_endline ("scc: " ^ why ^ ", and the step that was under way did not end");
  flush stderr;
  Unix._exit (Scc_session.Exit_code.to_int Stopped)

let over t (stage : Limits.stage) =
  match stage with
  | Exploring -> t.over
  | Concluding -> t.late
  | Reporting -> t.last

let look t =
  let passed = passed t in
  let bytes = if t.memory < infinity then resident () +. float_of_int (Memory.beside ()) else 0. in
  t.over <- beyond t ~passed ~bytes ~more:0. ~share:(1. -. left_to_conclusions);
  t.late <- beyond t ~passed ~bytes ~more:grace ~share:1.;
  t.last <- beyond t ~passed ~bytes ~more:(1.5 *. grace) ~share:1.1;
  match (t.stage, t.last) with
  | Some stage, _ ->
    let give_up stop = if not (Critical.active ()) then raise (Given_up stop) in
    Option.iter give_up (over t stage)
  | None, _ -> if passed > patience then abandon t

let timer seconds = ignore (Unix.setitimer ITIMER_REAL { it_interval = seconds; it_value = seconds })

let on_signals behaviour = List.iter (fun s -> Sys.set_signal s behaviour) [ Sys.sigint; Sys.sigterm ]

(* Seconds in which one wish to stop may arrive twice, sent to the program and to its group of processes. *)
let again = 0.5

let end_by signal =
  Sys.set_signal signal Sys.Signal_default;
  Unix.kill (Unix.getpid ()) signal

let start ?(clock = Unix.gettimeofday) ?(signals = true) ?seconds ?memory () =
  let t =
    {
      clock;
      signals;
      deadline = Option.fold ~none:infinity ~some:(fun s -> clock () +. s) seconds;
      memory =
        Option.fold ~none:infinity memory ~some:(fun w ->
            Float.min (address_space ()) (float_of_int (Memory.bytes_of_words w)));
      signalled = false;
      since = None;
      over = None;
      late = None;
      last = None;
      stage = None;
    }
  in
  let first = ref infinity in
  let arrived signal =
    if not t.signalled then begin
      t.signalled <- true;
      first := clock ();
      timer interval
    end
    else if clock () -. !first > again then end_by signal
  in
  if signals then on_signals (Signal_handle arrived);
  Sys.set_signal Sys.sigalrm (Sys.Signal_handle (fun _ -> look t));
  if Option.is_some seconds || Option.is_some memory then timer interval;
  t

let more t seconds =
  t.deadline <- t.deadline +. seconds;
  look t

let stop t () = t.over
let half t () : unit -> Limits.stop option =
  let now = t.clock () in
  let middle = now +. ((t.deadline -. now) /. 2.) in
  fun () -> match t.over with None when t.clock () > middle -> Some Seconds | over -> over

let interrupted t () = t.signalled

(* A wish to stop that comes as the report is written would keep it from whoever waits for it. *)
let finish t =
  timer 0.;
  t.stage <- None;
  if t.signals && not t.signalled then begin
    let since = t.clock () in
    on_signals (Signal_handle (fun signal -> if t.clock () -. since > again then end_by signal))
  end

(* What was given up for its memory has left it behind as garbage. *)
let compacted t stage =
  match over t stage with
  | Some Memory ->
    let outer = t.stage in
    t.stage <- None;
    Gc.compact ();
    look t;
    t.stage <- outer
  | Some (Seconds | Interrupted) | None -> ()

let attempted t stage f =
  (match (stage : Limits.stage) with Concluding | Reporting -> compacted t stage | Exploring -> ());
  match over t stage with
  | Some stop -> Error stop
  | None -> (
      let outer = t.stage in
      let leave () = t.stage <- outer in
      match
        t.stage <- Some stage;
        let x = f () in
        leave ();
        x
      with
      | x -> Ok x
      | exception Given_up stop ->
        leave ();
        Error stop
      | exception e ->
        leave ();
        raise e)

let attempt t : Limits.attempt = { run = (fun stage f -> attempted t stage f) }
