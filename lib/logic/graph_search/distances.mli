(** How far each state of a graph is from the initial one, in steps and in time, and by which paths. *)

open Scc_exact

type t

val create : unit -> t

(** What a path to a state comes to. *)
type label = {
  depth : int;  (** transitions *)
  arrival : int;  (** the number of its time, see {!time} *)
  instant : int;  (** transitions without passing time at its end *)
  before : int;  (** the last state before it; -1 for none *)
}

val origin : label
(** The empty path. *)

val push : t -> label -> unit
(** A state more, with its first path. *)

val depth : t -> int -> int
val arrival : t -> int -> Rat.t
val arrival_number : t -> int -> int
val instant : t -> int -> int
val time : t -> int -> Rat.t

val after : t -> int -> Rat.t option -> label
(** The label of a path to a state's successor; the duration of the last transition, if it takes time. *)

val improve : t -> int -> label -> bool * bool
(** Takes over what is better than known: whether the path is shorter, and whether it is earlier. *)

val before_nearest : t -> int -> int
(** The state before on the shortest path; -1 at the initial state. *)

val before_earliest : t -> int -> int

val greatest_depth : t -> int
val greatest_arrival : t -> Rat.t

val bytes : t -> int
(** About how much memory it takes. *)
