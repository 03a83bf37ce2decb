(** The states of an owner that are to be expanded, by the times at which they are reached, and those of one time
    in the order of their turns. A state that has become earlier since belongs to its new time alone. *)

open Scc_exact

type t

val make : Clock.t -> t
(** No states. *)

val put : t -> Rat.t -> int -> unit
(** [put d time id]: the state has come, or has become earlier, and is reached at this time. Turns increase. *)

val take : t -> Rat.t -> int array
(** The states of a time, which are removed. *)

val first : t -> none:int -> (Rat.t * int) option
(** The first time, with the least turn of its states; [none] if all of them have become earlier. *)

val iter : t -> (int -> unit) -> unit
(** Calls a function for each state. *)
