(** Connections of a listening socket: how cohttp reads requests from them and writes answers to them. The
    module for this purpose in cohttp-lwt-unix loads OpenSSL, and the certificates of the machine, whenever a
    program starts. *)

(** A connection with the bytes that are read and not used yet. *)
type conn

(** {1 The interface for cohttp} *)

include Cohttp_lwt.S.IO with type conn := conn and type ic = conn and type oc = Lwt_io.output_channel

val refill : ic -> [ `Ok | `Eof ] Lwt.t
(** Waits for input and reads it. Newer versions of cohttp need this function and the next. *)

val with_input_buffer : ic -> f:(string -> pos:int -> len:int -> 'a * int) -> 'a
(** The result of [f] on the bytes that are read and not used yet. The second result of [f] is the number of
    bytes that are used then. *)

(** {1 Life cycle} *)

val serve :
  stop:unit Lwt.t ->
  most:int ->
  head_seconds:float ->
  seconds:float ->
  Lwt_unix.file_descr ->
  (conn -> ic -> oc -> unit Lwt.t) ->
  unit Lwt.t
(** Handles each incoming connection until [stop]: at most [most] at a time, and each for at most [seconds]. If its
    head has not come after [head_seconds], a connection ends. When all places are taken, a new connection takes
    the place of the oldest one whose head has not come for a second. It waits if there is none. If a handler
    fails, only its connection ends. *)

val hear_body : conn -> unit
(** Allows the body of a request to be read. Before, at most 64 KiB are read. A line of the body (of one in
    parts) may be as long at most, so the memory of a connection is bounded. *)

val hear_no_more : conn -> unit
(** Ends reading: unread input is discarded, and there is no further request. *)
