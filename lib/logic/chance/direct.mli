(** Guesses for small components, by elimination in floats: with a good scheduler it takes the place of many
    sweeps. As for all guesses nothing is proved ({!Rounded}). *)

val greatest : int
(** 8: the nodes of a component, at most. Elimination takes time as the third power of that. *)

type t
(** Room for the work. *)

val room : unit -> t

val evaluate : t -> Rounded.t -> first:int -> last:int -> bool
(** The nodes from first to last, no more than {!greatest}, become in [guess] what the rows in [row] make of them,
    with the others as they are. If floats show no such values, nothing is changed: [false]. *)
