(** Child processes that answer lines by lines over their standard input and output. They share the standard
    error of this program. *)

(** A child process. *)
type t

(** Why a question has no answer. *)
type failure =
  | Over  (** the process has ended *)
  | Too_slow  (** it did not answer in time, and has been ended *)
  | Busy  (** too many questions wait *)

val start : string array -> t
(** Starts this program with these arguments, of which the first is its name. SIGINT is blocked in the child
    until it unblocks it. Raises [Unix.Unix_error] if the system has no resources left. *)

val say : t -> string -> unit Lwt.t
(** Sends a line that has no answer. *)

val hear : t -> string option Lwt.t
(** The next line that answers no question; [None] after the last one. *)

val ask : t -> seconds:float -> string -> (string, failure) result Lwt.t
(** The answer to a line, after those to all earlier questions. If it takes more than [seconds], the child is
    ended. *)

val interrupt : t -> unit
(** Sends SIGINT. *)

val discard : t -> unit Lwt.t
(** Ends the child by SIGKILL and waits for its end. *)

val alive : t -> bool
(** [alive t] is true until the child has ended. *)
