(** The levels of the states of one owner. The states of a level have consecutive numbers, and ranks. *)

type t

val make : unit -> t
(** No levels. *)

val count : t -> int
(** The number of levels. *)

val start : t -> int -> int
(** The number of the first state of a level, or of the one behind the last level. *)

val add : t -> int array -> unit
(** Adds a level, with the ranks of its states in the order of their numbers. *)

val rank : t -> int -> int
(** The rank of a state. *)

val by_rank : t -> int -> int array
(** The states of a level in the order of their ranks. *)

val level : t -> int -> int
(** The level of a state. *)

val find : t -> int -> int -> int option
(** [find l level rank] is the state of this owner with that rank in the level. *)
