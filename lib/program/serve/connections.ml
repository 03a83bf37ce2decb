open Lwt.Syntax

type 'a t = 'a Lwt.t

let ( >>= ) = Lwt.bind
let return = Lwt.return

type heard =
  | Head of int  (** how much of it may come *)
  | Body
  | No_more

(* The bytes from [first] to [last] are read, and not used yet. *)
type conn = {
  socket : Lwt_unix.file_descr;
  mutable bytes : Bytes.t;
  mutable first : int;
  mutable last : int;
  mutable heard : heard;
  over : unit Lwt.t * unit Lwt.u;  (** resolved when no more is heard: nobody waits for what does not come *)
  dropped : unit Lwt.t * unit Lwt.u;  (** resolved when it gives its place to another one *)
  since : float;
}

type ic = conn
type oc = Lwt_io.output_channel
type error = Unix.error

let pp_error f e = Format.pp_print_string f (Unix.error_message e)

let catch f =
  Lwt.catch
    (fun () -> Lwt.map Result.ok (f ()))
    (function Unix.Unix_error (e, _, _) -> Lwt.return_error e | e -> Lwt.fail e)

(* {1 Reading} *)

let most_of_head = 64 * 1024
let piece = 4096

let make_way c =
  let kept = c.last - c.first in
  let bytes = if kept + piece > Bytes.length c.bytes then Bytes.create (2 * Bytes.length c.bytes) else c.bytes in
  Bytes.blit c.bytes c.first bytes 0 kept;
  c.bytes <- bytes;
  c.first <- 0;
  c.last <- kept

let too_long () = Lwt.fail (Unix.Unix_error (EMSGSIZE, "read", ""))

(* What is not used yet is the beginning of a line, or of a head: no more of one is kept than a head may have. *)
let receive c =
  if c.last - c.first >= most_of_head then too_long ()
  else begin
    if c.last + piece > Bytes.length c.bytes then make_way c;
    let* n = Lwt_unix.read c.socket c.bytes c.last piece in
    c.last <- c.last + n;
    Lwt.return n
  end

(* What cohttp makes of a head that is cut off may be a request: too long a one has no answer. *)
let refill c =
  let more n = if n = 0 then `Eof else `Ok in
  match c.heard with
  | No_more -> Lwt.return `Eof
  | Body -> Lwt.pick [ Lwt.map more (receive c); Lwt.map (fun () -> `Eof) (fst c.over) ]
  | Head room when room <= 0 -> too_long ()
  | Head room ->
    let* n = receive c in
    c.heard <- Head (room - n);
    Lwt.return (more n)

let with_input_buffer c ~f =
  let found, used = f (Bytes.unsafe_to_string c.bytes) ~pos:c.first ~len:(c.last - c.first) in
  c.first <- c.first + used;
  found

let take c n = with_input_buffer c ~f:(fun text ~pos ~len:_ -> (String.sub text pos n, n))

let rec read c most =
  match c.last - c.first with
  | 0 -> (
      let* more = refill c in
      match more with `Ok -> read c most | `Eof -> Lwt.return "")
  | here -> Lwt.return (take c (min here most))

let without_return line =
  match String.length line with
  | 0 -> line
  | n -> if line.[n - 1] = '\r' then String.sub line 0 (n - 1) else line

(* What lies within [seen] bytes is no end of a line. *)
let rec line_after c seen =
  match Bytes.index_from_opt c.bytes (c.first + seen) '\n' with
  | Some k when k < c.last ->
    let line = take c (k - c.first) in
    c.first <- c.first + 1;
    Lwt.return_some (without_return line)
  | Some _ | None -> (
      let seen = c.last - c.first in
      let* more = refill c in
      match more with
      | `Ok -> line_after c seen
      | `Eof -> if seen = 0 then Lwt.return_none else Lwt.return_some (without_return (take c seen)))

let read_line c = line_after c 0

(* {1 Writing} *)

let write = Lwt_io.write
let flush = Lwt_io.flush

(* {1 Lives} *)

let hear_body c = c.heard <- Body

let hear_no_more c =
  c.first <- c.last;
  c.heard <- No_more;
  if Lwt.is_sleeping (fst c.over) then Lwt.wakeup_later (snd c.over) ()

(* Whether a request comes is not waited for any longer: its connection ends without an answer. *)
let head_is_late ~head_seconds c =
  let* () = Lwt_unix.sleep head_seconds in
  match c.heard with Head _ -> Lwt.return_unit | Body | No_more -> fst (Lwt.task ())

let started socket =
  let bytes = Bytes.create (2 * piece) in
  { socket; bytes; first = 0; last = 0; heard = Head most_of_head; over = Lwt.wait (); dropped = Lwt.wait ();
    since = Unix.gettimeofday () }

let attend ~head_seconds ~seconds handle c =
  let out = Lwt_io.of_fd ~mode:Lwt_io.output c.socket in
  Lwt.finalize
    (fun () ->
       Lwt.catch
         (fun () ->
            Lwt_unix.with_timeout seconds (fun () ->
                Lwt.pick [ handle c c out; head_is_late ~head_seconds c; fst c.dropped ]))
         (fun _ -> Lwt.return_unit))
    (fun () ->
       hear_no_more c;
       Lwt.catch (fun () -> Lwt_io.abort out) (fun _ -> Lwt.return_unit))

(* A machine that has no descriptors left will have some when others end. *)
let rec accepted socket =
  Lwt.catch
    (fun () -> Lwt.map fst (Lwt_unix.accept ~cloexec:true socket))
    (function
      | Unix.Unix_error _ ->
        let* () = Lwt_unix.sleep 0.1 in
        accepted socket
      | e -> Lwt.fail e)

(* The oldest connection whose request is still to come. Those that have spoken are forgotten on the way. *)
let rec oldest_silent waiting =
  match Queue.peek_opt waiting with
  | Some { heard = Body | No_more; _ } ->
    ignore (Queue.pop waiting);
    oldest_silent waiting
  | (Some { heard = Head _; _ } | None) as oldest -> oldest

(* A silent connection keeps its place so long: many requests may arrive at one moment, and are read one by one. *)
let quiet_seconds = 1.

(* Until a connection ends. The oldest silent one does so, once it has been silent for long enough. *)
let room free waiting =
  match oldest_silent waiting with
  | None -> Lwt_condition.wait free
  | Some c ->
    let left = c.since +. quiet_seconds -. Unix.gettimeofday () in
    if left > 0. then Lwt.pick [ Lwt_condition.wait free; Lwt_unix.sleep (Float.min left quiet_seconds) ]
    else begin
      let ended = Lwt_condition.wait free in
      ignore (Queue.pop waiting);
      Lwt.wakeup_later (snd c.dropped) ();
      ended
    end

(* Of very many in a row, those that have spoken are not kept. *)
let forget_spoken waiting ~most =
  if Queue.length waiting > 2 * most then begin
    let silent = Queue.create () in
    Queue.iter (fun c -> match c.heard with Head _ -> Queue.add c silent | Body | No_more -> ()) waiting;
    Queue.clear waiting;
    Queue.transfer silent waiting
  end

let serve ~stop ~most ~head_seconds ~seconds socket handle =
  let free = Lwt_condition.create () and open_ = ref 0 and waiting = Queue.create () in
  let attended c =
    incr open_;
    Queue.add c waiting;
    forget_spoken waiting ~most;
    let ended () =
      decr open_;
      Lwt_condition.signal free ();
      Lwt.return_unit
    in
    Lwt.async (fun () -> Lwt.finalize (fun () -> attend ~head_seconds ~seconds handle c) ended)
  in
  let rec go_on () =
    let* one = accepted socket in
    let* () = place () in
    attended (started one);
    go_on ()
  and place () =
    if !open_ < most then Lwt.return_unit
    else Lwt.bind (room free waiting) place
  in
  let* () = Lwt.pick [ stop; go_on () ] in
  Lwt_unix.close socket
