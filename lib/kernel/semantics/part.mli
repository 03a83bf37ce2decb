(** The basic shapes of a state as the rules of contact use them: where each is, and in which process it moves. *)

open Scc_exact
open Scc_rigid
open Scc_calculus

type t = {
  process : int;  (** index of its process in the state *)
  owner : State.process;  (** the process *)
  leaf : State.leaf;
  index : int;  (** index of the part in the leaf *)
  placed : Placed.t;  (** where it is now, in the world *)
  centre : Vec.t;
  (** world position of what it turns about, the centre of mass of its process, in the rigid calculus; else that
      of its reference point *)
}

val name : t -> int * int
(** The indices of its leaf and of the part in it, which identify a part of a network. *)

val velocity : t -> Vec.t
(** The velocity of the centre, in the world. *)

val turns : t -> bool
(** [turns p] is true if the spin of its process is not zero. *)

val relative_velocity : t -> t -> Vec.t
(** [relative_velocity a b] is the velocity of the centre of [b] less that of [a]. For bodies that do not turn,
    it is the relative velocity of all their points. *)

val in_relative_motion : t -> t -> bool
(** [in_relative_motion a b] is true if [a] and [b] are of two processes with different velocities, or of two
    processes one of which turns. Only such parts ever collide. *)

val move_alike : t array -> bool
(** [move_alike parts] is true if no two of [parts] are in relative motion. *)

val reach : t -> Rat.t
(** An upper bound on the distance of its points from the centre. It stays the same as the part turns. *)
