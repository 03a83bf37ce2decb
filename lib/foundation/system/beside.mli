(** Processes beside this one, each with one end of a pair of descriptors. *)

val fork :
  (unit -> Unix.file_descr * Unix.file_descr) -> (Unix.file_descr -> Unix.file_descr -> 'a) -> 'a option
(** [fork pair start] is the result of [start ours theirs] for the descriptors [(ours, theirs)] of [pair ()].
    [start] starts a process by {!Interruption.fork}, which uses [theirs]; this process then closes [theirs]. The
    result is [None] if the system refuses descriptors or a process, or if [select] does not accept [ours]. *)

val labour : (unit -> unit) -> 'a
(** [labour work] calls [work ()] and ends the process without the functions of [at_exit]. The exit code is 0. It
    is 4 if the system refuses a resource ({!Resources.refused}): the process that started this one reports it. It
    is 70 after any other exception, which is written to standard error. *)
