(** The distances of states of a graph from the initial one, in steps and in time, and the paths of these
    distances. *)

open Scc_exact

type t

val create : unit -> t
(** [create ()] has no states. *)

(** The length of a path to a state. *)
type label = {
  depth : int;  (** the number of transitions *)
  arrival : int;  (** the number of its time, see {!time} *)
  instant : int;  (** the number of transitions at its end that take no time *)
  before : int;  (** the last state before the end; -1 for the empty path *)
}

val origin : label
(** The label of the empty path. *)

val push : t -> label -> unit
(** [push d label] adds the next state, with the label of its first path. *)

val depth : t -> int -> int
(** [depth d i] is the least number of transitions to state [i], over the paths given so far. *)

val arrival : t -> int -> Rat.t
(** [arrival d i] is the least model time of a path to state [i], over the paths given so far. *)

val arrival_number : t -> int -> int
(** [arrival_number d i] is the number of [arrival d i], see {!time}. Equal times have equal numbers. *)

val instant : t -> int -> int
(** [instant d i] is the number of transitions without time at the end of the shortest path to state [i]. *)

val time : t -> int -> Rat.t
(** [time d n] is the model time with number [n]; number 0 is time 0. *)

val after : t -> int -> transitions:int -> Rat.t option -> label
(** [after d i ~transitions duration] is the label of a path through state [i] to its successor. The last edge of
    the path stands for [transitions] transitions. [duration] is its time, or [None] if it takes none. *)

val improve : t -> int -> label -> bool * bool
(** [improve d i label] stores a path to state [i] where it is better than the known ones. The result says if it is
    shorter, and if it is earlier. *)

val before_nearest : t -> int -> int
(** [before_nearest d i] is the state before [i] on the shortest path; -1 at the initial state. *)

val before_earliest : t -> int -> int
(** [before_earliest d i] is the state before [i] on the earliest path; -1 at the initial state. *)

val greatest_depth : t -> int
(** [greatest_depth d] is the greatest {!val-depth} of a state, in linear time. *)

val greatest_arrival : t -> Rat.t
(** [greatest_arrival d] is the greatest {!val-arrival} of a state, in linear time. *)

val bytes : t -> int
(** [bytes d] is about how much memory the table takes, in bytes. *)
