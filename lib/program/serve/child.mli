(** Processes that answer lines by lines over their standard input and output. What they say on standard error is
    said on that of this program. *)

type t

(** Why a question has no answer. *)
type failure =
  | Over  (** the process has ended *)
  | Too_slow  (** it has been ended, as it did not answer in time *)
  | Busy  (** too many questions wait *)

val start : string array -> t
(** Of this program with these arguments (the first one is its name). SIGINT is blocked in it until it says
    otherwise. *)

val say : t -> string -> unit Lwt.t
(** A line to which there is no answer. *)

val hear : t -> string option Lwt.t
(** The next line that answers no question; none when there are no more. *)

val ask : t -> seconds:float -> string -> (string, failure) result Lwt.t
(** The answer to a line, after those to all questions before it. *)

val interrupt : t -> unit
(** Sends SIGINT. *)

val discard : t -> unit Lwt.t
(** Ends it, whatever it does. *)

val alive : t -> bool
