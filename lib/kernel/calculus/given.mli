(** What laws of motion give to a process at one instant (rules Steer and Draw). *)

open Scc_exact

type t = {
  velocity : Vec.t;  (** of the centre of mass, in the world *)
  spin : Vec.t option;
  (** angular velocity in the world, in radians per unit of time; [None] if no law of the process gives one *)
}

val compare : t -> t -> int
(** The order of draws: by the velocity, then by the spin, each by x, y, z. *)

val equal : t -> t -> bool
(** [equal a b] is true if both velocities and both spins are equal. *)

val hash : t -> int
(** A hash that agrees with {!equal}. *)

val to_string : t -> string
(** [to_string g] is the velocity, and the spin after its word if there is one: [(1, 0, 0) spin (0, 0, 1/2)]. *)
