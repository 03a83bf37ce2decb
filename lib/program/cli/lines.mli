(** Lines from standard input, of a bounded length, and how to know that one would have to wait for the next. *)

type t

val make : most:int -> t

type line =
  | Line of string  (** without its end *)
  | Too_long  (** one of more than [most] bytes, which was skipped *)
  | End

val next : t -> wait:(unit -> unit) -> line
(** [wait] is called before each reading that may have to wait for more. What comes after the last end of a line is
    a line, too, unless it is empty. {!Scc_system.Reading.Failed}. *)
