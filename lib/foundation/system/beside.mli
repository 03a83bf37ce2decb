(** Processes beside this one, each with one end of a pair of descriptors. *)

val fork :
  (unit -> Unix.file_descr * Unix.file_descr) -> (Unix.file_descr -> Unix.file_descr -> 'a) -> 'a option
(** [fork pair start] makes a pair, this process's end first, and starts a process that has the other end
    ({!Interruption.fork}), which is closed here. [None] where the system gives no descriptor, none that [select]
    takes, or no process. *)

val labour : (unit -> unit) -> 'a
(** What such a process does, without what its parent would do at its end: exit code 0, or 70 after an exception,
    which is told. *)
