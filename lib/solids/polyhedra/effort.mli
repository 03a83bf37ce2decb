(** A budget of work with linear forms and systems, by which a long search is given up at the same place on
    every machine. The unit of work is a visit of one coefficient of a form or of one entry of a {!Tableau}.
    Machines do five to twenty million units a second. *)

val within : most:int -> (unit -> 'a) -> 'a option
(** [within ~most f] is [Some (f ())], or [None] if that takes more than [most] units of work; the rest is then
    not done. Values that [f] has begun must not be used after [None]: a lazy value whose evaluation was
    interrupted fails for ever. *)

val spend : int -> unit
(** [spend n] subtracts [n] units from the budget of the innermost {!within} and ends it if none are left. It
    must not be called inside a function that catches all exceptions. *)
