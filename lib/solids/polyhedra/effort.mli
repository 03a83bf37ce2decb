(** How much work linear forms and systems have made, so that a search which may take for ever is given up at the
    same place on every machine. The unit is a coefficient of a form, or an entry of a {!Tableau}, that is looked
    at: five to twenty million a second. *)

val within : most:int -> (unit -> 'a) -> 'a option
(** What comes of it; [None] if it takes more work, of which the rest is not done. What it has begun to find must
    not be used any more: a value that was being found lazily fails for ever. *)

val spend : int -> unit
(** So much work is about to be done. To be called within no function that catches all exceptions. *)
