(** Connections of a socket that listens: how cohttp reads requests from them and writes answers to them.
    Its own way to do so (cohttp-lwt-unix) loads OpenSSL, and the certificates of the machine, whenever a program
    starts. *)

type conn

(** {1 What cohttp asks for} *)

include Cohttp_lwt.S.IO with type conn := conn and type ic = conn and type oc = Lwt_io.output_channel

val refill : ic -> [ `Ok | `Eof ] Lwt.t
(** Reads what there is, waiting for it (newer versions of cohttp ask for this and for what follows). *)

val with_input_buffer : ic -> f:(string -> pos:int -> len:int -> 'a * int) -> 'a
(** What f makes of what was read and is not used yet; f tells how much of it is used then. *)

(** {1 Their lives} *)

val serve :
  stop:unit Lwt.t ->
  most:int ->
  seconds:float ->
  Lwt_unix.file_descr ->
  (conn -> ic -> oc -> unit Lwt.t) ->
  unit Lwt.t
(** Hands on each connection that comes, until [stop]: [most] at a time, while others wait, and each for so many
    seconds at the most. When a handler fails, the connection ends, and nothing else. *)

val hear_body : conn -> unit
(** What comes after the head of a request is heard. Before, no more than 64 KiB are; nor is a longer line of the
    body (of one in parts), so that what is kept of a connection is bounded. *)

val hear_no_more : conn -> unit
(** What is not read yet is never read: there is no further request. *)
