open Scc_base
open Scc_system
open Scc_graph_search

(* Seconds from one look to the next; heaps grow by some ten megabytes in the meantime. Where addresses are scarce
   these may be all that there are. *)
let interval = 0.01
let short_interval = 0.002

(* Seconds of the processor that conclusions have, and half as many that the report has after them; and those
   after which the work is broken off without one. *)
let grace = 1.
let patience = 3.

(* How much of the memory explorations leave to conclusions. *)
let left_to_conclusions = 0.25

(* And how much of it the report has. *)
let last_share = 1.1

exception Given_up of Limits.stop

type t = {
  clock : unit -> float;
  mutable deadline : float;
  mutable memory : float;  (** in bytes *)
  mutable signalled : bool;
  mutable since : float option;  (** the processor's seconds when the time was over, or a signal came *)
  mutable over : Limits.stop option;  (** for what explores *)
  mutable late : Limits.stop option;  (** for what concludes *)
  mutable last : Limits.stop option;  (** for what reports *)
  mutable stage : Limits.stage option;  (** of the attempt that is being made *)
  mutable middle : float;  (** when it is given up with seconds left, for what comes after it *)
  mutable concluded : float;  (** the same of what concludes, as a {!position} *)
  mutable abandoned : bool;  (** it was tried *)
  mutable reading : bool;  (** no attempt has been made *)
  mutable attempts : bool;  (** some has been made: between two of them little memory is taken *)
  before : float;  (** bytes of memory at the start *)
  mutable finished : float option;  (** the seconds that the rest has after a signal, once the work has stopped *)
}

(* Seconds of the processor since the time was over: on a busy machine those of the clock say little of the
   work. *)
let passed t =
  let over = t.signalled || t.clock () > t.deadline in
  match t.since with
  | Some since when over -> Sys.time () -. since
  | Some _ | None ->
    t.since <- (if over then Some (Sys.time ()) else None);
    if over then 0. else -1.

(* Where the work is: the seconds of the clock until the time is over, as a negative number, and those of the
   processor since then. *)
let position t =
  let passed = passed t in
  if passed >= 0. then passed else t.clock () -. t.deadline

(* What is over when so many seconds more, and such a share of the memory, are allowed. *)
let beyond t ~passed ~taken ~(more : float) ~(share : float) : Limits.stop option =
  if passed >= more then Some (if t.signalled then Interrupted else Seconds)
  else if taken > share then Some Memory
  else None

(* Of the memory, or of the addresses if this is more. *)
let resident () = Footprint.resident () +. float_of_int (Memory.beside ())

let taken t =
  let memory = if t.memory < infinity then resident () /. t.memory else 0. in
  Float.max memory (Footprint.taken ())

(* What nobody attempts is broken off once; if that does not end it, the program ends. Nothing is flushed: what was
   printed so far may be half of a report. *)
let abandon t ~passed =
  let why = if t.signalled then "interrupted" else "the limit of seconds has passed" in
  let why = why ^ ", and the step that was under way did not end" in
  if passed > 2. *. patience then begin
    Standard.complain ("scc: " ^ why ^ "\n");
    Unix._exit (Scc_verdicts.Exit_code.to_int Stopped)
  end
  else if not (t.abandoned || Critical.active ()) then begin
    t.abandoned <- true;
    raise (Interruption.Interrupted why)
  end

(* Bytes that reading may take under any limit: then a small model is always read, and a report says what is
   known of it. *)
let for_reading = 64. *. float_of_int Memory.mib

let limit_reading t ~taken =
  if t.reading && taken > 1. && not (Critical.active ()) && resident () > t.before +. for_reading then begin
    t.reading <- false;
    raise (Interruption.Interrupted "the limit of memory was met before the input was read")
  end

let over t (stage : Limits.stage) =
  match stage with
  | Exploring | Proving -> t.over
  | Concluding -> t.late
  | Reporting -> t.last

let look t =
  let passed = passed t in
  let taken = taken t in
  t.over <- beyond t ~passed ~taken ~more:0. ~share:(1. -. left_to_conclusions);
  t.late <- beyond t ~passed ~taken ~more:grace ~share:1.;
  t.last <- beyond t ~passed ~taken ~more:(1.5 *. grace) ~share:last_share;
  (match t.over with
   | Some Seconds -> Interruption.expire "the limit of seconds has passed before the input was read"
   | Some (Memory | Interrupted) | None -> ());
  match (t.stage, t.last) with
  | Some stage, _ ->
    (* Once: where signals come late, the next one may come before what is raised has been caught. *)
    let give_up stop =
      if not (Critical.active ()) then begin
        t.stage <- None;
        raise (Given_up stop)
      end
    in
    let half_over =
      match stage with
      | Exploring | Proving -> t.clock () > t.middle
      | Concluding -> (not t.signalled) && position t > t.concluded
      | Reporting -> false
    in
    Option.iter give_up (over t stage);
    if half_over then give_up Seconds
  | None, _ -> (
      match t.finished with
      | Some grace -> if passed > grace then Interruption.break_off ()
      | None ->
        limit_reading t ~taken;
        if passed > patience then abandon t ~passed;
        if Footprint.taken () > last_share && not (t.attempts || Critical.active ()) then raise Out_of_memory)

let timer seconds = ignore (Unix.setitimer ITIMER_REAL { it_interval = seconds; it_value = seconds })

let start ?(clock = Unix.gettimeofday) ?(signals = true) ?seconds ?memory () =
  let t =
    {
      clock;
      deadline = Option.fold ~none:infinity ~some:(fun s -> clock () +. s) seconds;
      memory =
        Option.fold ~none:infinity memory ~some:(fun w -> float_of_int (Memory.bytes_of_words w));
      signalled = false;
      since = None;
      over = None;
      late = None;
      last = None;
      stage = None;
      middle = infinity;
      concluded = infinity;
      abandoned = false;
      reading = signals;
      attempts = false;
      before = resident ();
      finished = None;
    }
  in
  let arrived () =
    t.signalled <- true;
    timer interval
  in
  if signals then Interruption.answered arrived;
  Sys.set_signal Sys.sigalrm (Sys.Signal_handle (fun _ -> look t));
  let interval = if Footprint.is_limited then short_interval else interval in
  if Option.is_some seconds || Option.is_some memory || Footprint.is_limited then timer interval;
  t

let more t seconds =
  t.deadline <- t.deadline +. seconds;
  look t

let stop t () = t.over
let has_read t = t.reading <- false

(* When a part of the work is over: what explores, by the clock, and what concludes, as a {!position}. *)
type until = { explored : float; concluded : float }

let whole = { explored = infinity; concluded = infinity }
let is_whole until = until.explored = infinity && until.concluded = infinity

(* After a part of what is left until then. *)
let after t part ~until =
  let now = t.clock () in
  now +. (part *. Float.max 0. (Float.min until t.deadline -. now))

let middle t until = { until with explored = after t 0.5 ~until:until.explored }

(* Of its share, what explores has so much. *)
let explored_share = 0.75

let share t until ~mine ~all =
  if t.deadline = infinity then until
  else
    let part = float_of_int mine /. float_of_int all and here = position t in
    let left = Float.max 0. (Float.min until.concluded grace -. here) in
    {
      explored = after t (explored_share *. part) ~until:until.explored;
      concluded = here +. (part *. left);
    }

let stopped t ~until:{ explored; _ } () : Limits.stop option =
  match t.over with None when explored < infinity && t.clock () > explored -> Some Seconds | over -> over

let half t () = stopped t ~until:(middle t whole)

let interrupted t () = t.signalled

let reason : Limits.stop -> string = function
  | Interrupted -> "interrupted"
  | Seconds -> "the limit of seconds has passed"
  | Memory -> "the limit of memory was met"

(* What has been explored may take as long to be written as it takes; but who wishes to stop, before or meanwhile,
   waits no longer than for conclusions. *)
let finish ?(grace = grace) t =
  timer 0.;
  t.stage <- None;
  t.finished <- Some grace;
  t.deadline <- infinity;
  t.memory <- infinity;
  t.since <- None;
  (* A report is written as one text. Among few addresses the heap has to grow by no more than that takes. *)
  if Footprint.is_limited then begin
    if Footprint.taken () > 0.5 then Scc_system.Garbage.compact ();
    Gc.set { (Gc.get ()) with major_heap_increment = 1 lsl 17 }
  end;
  if t.signalled then timer interval

let dismiss t =
  finish t;
  timer 0.

(* What has ended, or was given up for its memory, has left it behind as garbage. *)
let compacted t stage =
  match over t stage with
  | Some Memory ->
    Critical.run (fun () ->
        Scc_system.Garbage.compact ();
        look t)
  | Some (Seconds | Interrupted) | None -> ()

let attempted t stage f =
  t.reading <- false;
  t.attempts <- true;
  (match (stage : Limits.stage) with Concluding | Reporting -> compacted t stage | Exploring | Proving -> ());
  match over t stage with
  | Some stop -> Error stop
  | None -> (
      let outer = t.stage in
      let leave () = t.stage <- outer in
      (* Of a search for a proof hardly anything stays, and exploring comes after it. *)
      let left result =
        (match stage with Proving -> compacted t Exploring | Exploring | Concluding | Reporting -> ());
        result
      in
      match
        t.stage <- Some stage;
        let x = f () in
        leave ();
        x
      with
      | x -> left (Ok x)
      | exception Given_up stop ->
        (* What comes next may need memory, and is no attempt that could be given up. *)
        Critical.run (fun () ->
            leave ();
            match (outer, stop) with
            | None, Memory -> Scc_system.Garbage.compact ()
            | _ -> ());
        left (Error stop)
      | exception Out_of_memory when Option.is_none outer ->
        (* Nothing of what may be left half done is used any more. Before it is collected, there is too little
           memory for anything, and a look would say so. *)
        Critical.run (fun () ->
            leave ();
            Scc_system.Garbage.compact ());
        Error Memory
      | exception e ->
        leave ();
        raise e)

let attempt t : Limits.attempt = { run = (fun stage f -> attempted t stage f) }

(* What is within another part ends with it. *)
let before t until (attempt : Limits.attempt) : Limits.attempt =
  let run (type a) (stage : Limits.stage) (f : unit -> a) : (a, Limits.stop) result =
    let is_over =
      match stage with
      | Exploring | Proving -> stopped t ~until () = Some Seconds
      | Concluding -> (not t.signalled) && position t > until.concluded
      | Reporting -> false
    in
    let middle = t.middle and concluded = t.concluded in
    let leave () =
      t.middle <- middle;
      t.concluded <- concluded
    in
    if is_over then Error Seconds
    else begin
      t.middle <- Float.min middle until.explored;
      t.concluded <- Float.min concluded until.concluded;
      match attempt.run stage f with
      | result ->
        leave ();
        result
      | exception e ->
        leave ();
        raise e
    end
  in
  { run }

let surroundings t ~progress ~attempt =
  let rec within until : Limits.surroundings =
    {
      stop = stopped t ~until;
      half = (fun () -> within (middle t until));
      share = (fun ~mine ~all -> within (share t until ~mine ~all));
      progress;
      attempt = (if is_whole until then attempt else before t until attempt);
    }
  in
  within whole
