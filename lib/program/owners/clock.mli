(** When the states of one owner are reached, where they are taken in the order of time. *)

open Scc_exact

type t

val make : unit -> t
(** No states. The time 0 has the number 0. *)

(** {1 Times, by numbers} *)

val number : t -> Rat.t -> int
(** The number of a time. Equal times have equal numbers. *)

val time : t -> int -> Rat.t
(** The time with a number. *)

(** {1 States} *)

(** The transition by which a state was found: the state before, by its turn, and the place of the transition. *)
type first = { before : int; choice : int }

val add : t -> time:int -> first -> unit
(** The next state has come, and is reached at the time of this number. *)

(** What another transition to a state changes. *)
type change =
  | Nothing
  | Earlier  (** the state is reached earlier than was known *)
  | Same  (** as early, and the state has come or become earlier in this round *)

val again : t -> int -> time:int -> first -> change
(** [again c id ~time transition] is what the transition changes; where it is [Earlier] that is noted. *)

val arrival : t -> int -> int
(** The number of the earliest time at which the state is known to be reached. *)

val touched : t -> (int * first option) list
(** The states that have come in this round, each with the first transition to it, and those that have become
    earlier, in no order. *)

val close : t -> unit
(** A new round begins. *)

(** {1 Turns}

    A turn is the place of a state among all that have come or become earlier, at all owners. States of one time
    are expanded in this order. *)

val set_turn : t -> int -> int -> unit
(** [set_turn c id turn]: the last turn of a state counts. *)

val turn : t -> int -> int
(** The turn of a state. *)

val find : t -> int -> int option
(** The state of this owner whose turn this is. All turns must be set. *)
