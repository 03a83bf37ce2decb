(** How owners find each other: each calls those of smaller numbers, and is called by the others. *)

val meet :
  Greeting.self ->
  listener:Unix.file_descr ->
  peers:(string * int) list ->
  seconds:float ->
  Link.t option array
(** [meet self ~listener ~peers ~seconds] is the connections to all other owners, by their numbers; there is none
    to this owner. [peers] has the host and port of each owner, in order. Strangers that call are turned away,
    and cost no time. Raises {!Failure.Failed} if an owner that is called is another one, cannot be reached, or
    if not all have come in time. It closes [listener]. *)
