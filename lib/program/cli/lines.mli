(** Lines of bounded length from standard input, with a notice before each wait. *)

(** A reader of standard input. *)
type t

val make : most:int -> t
(** A reader for lines of at most [most] bytes. *)

(** A line that was read. *)
type line =
  | Line of string  (** without its end *)
  | Too_long  (** one of more than [most] bytes, which was skipped *)
  | End

val next : t -> wait:(unit -> unit) -> line
(** The next line. [wait] is called before each read that may have to wait. Text after the last line end is a
    line too, unless it is empty. Raises {!Scc_system.Reading.Failed}. *)
