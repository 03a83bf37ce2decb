(** Guesses for small components, by Gaussian elimination in floats: with a good scheduler it replaces many sweeps.
    As all guesses, its results prove nothing ({!Rounded}). *)

val greatest : int
(** 8: the greatest size of a component, in nodes. Elimination takes time with the third power of the size. *)

type t
(** Working memory: the matrix of the equations. *)

val room : unit -> t
(** [room ()] is new working memory, for any number of evaluations, one at a time. *)

val evaluate : t -> Rounded.t -> first:int -> last:int -> bool
(** [evaluate room r ~first ~last] solves the equations of the rows in [row] of the nodes from [first] to [last],
    with all other nodes as they are, and puts the solution into [guess]. There are at most {!greatest} nodes. If
    the rows seem to leave some node with a probability of at most 2^-40, it is [false] and changes nothing. *)
