open Scc_system

exception Closed

type t = { fd : Unix.file_descr; pid : int;  (** of the other process; 0 there *) head : Bytes.t }

(** {2 Whole messages}

    The length of a message in four bytes, and then the message. *)

let rec again f = match f () with x -> x | exception Unix.Unix_error (EINTR, _, _) -> again f

let closed f =
  match again f with
  | x -> x
  | exception Unix.Unix_error ((EPIPE | ECONNRESET | EBADF), _, _) -> raise Closed

let rec write c bytes from left =
  if left > 0 then begin
    let n = closed (fun () -> Unix.write c.fd bytes from left) in
    write c bytes (from + n) (left - n)
  end

let rec read c bytes from left =
  if left > 0 then begin
    let n = closed (fun () -> Unix.read c.fd bytes from left) in
    if n = 0 then raise Closed;
    read c bytes (from + n) (left - n)
  end

let put c message =
  let length = Buffer.length message in
  let bytes = Bytes.create (4 + length) in
  Bytes.set_int32_le bytes 0 (Int32.of_int length);
  Buffer.blit message 0 bytes 4 length;
  write c bytes 0 (4 + length)

let get c =
  read c c.head 0 4;
  let length = Int32.to_int (Bytes.get_int32_le c.head 0) in
  let bytes = Bytes.create length in
  read c bytes 0 length;
  Bytes.unsafe_to_string bytes

let readable seconds list =
  match Unix.select (List.map (fun c -> c.fd) list) [] [] seconds with
  | fds, _, _ -> List.filter (fun c -> List.memq c.fd fds) list
  | exception Unix.Unix_error (EINTR, _, _) -> []

let ready ?(seconds = 0.2) list = readable (Float.max 0. (Float.min 0.2 seconds)) list

(** {2 Processes} *)

(* Without the process that forked it, a child ends when it waits for a message, or tells of something. *)
let child fd work =
  (* The files of tables are those of the other process as well. *)
  Scc_data.Spill.nowhere ();
  Sys.set_signal Sys.sigpipe Sys.Signal_ignore;
  Beside.labour (fun () -> try work { fd; pid = 0; head = Bytes.create 4 } with Closed -> ())

let fork_with work ours theirs =
  let work () =
    Unix.close ours;
    child theirs work
  in
  { fd = ours; pid = Interruption.fork work; head = Bytes.create 4 }

let fork work = Beside.fork (fun () -> Unix.socketpair ~cloexec:true PF_UNIX SOCK_STREAM 0) (fork_with work)

let close c =
  (match Unix.kill c.pid Sys.sigkill with () | (exception Unix.Unix_error _) -> ());
  (match Unix.close c.fd with () | (exception Unix.Unix_error _) -> ());
  match again (fun () -> Unix.waitpid [] c.pid) with _ -> () | exception Unix.Unix_error _ -> ()
