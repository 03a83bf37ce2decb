(** The basic shapes of a state as the rules of contact see them: each where it stands, with whom it goes. *)

open Scc_exact
open Scc_rigid
open Scc_calculus

type t = {
  process : int;  (** index of its process in the state *)
  owner : State.process;  (** the process *)
  leaf : State.leaf;
  index : int;  (** of the part in the leaf *)
  placed : Placed.t;  (** where it is now, in the world *)
  centre : Vec.t;  (** what it turns about, if it turns: the centre of mass of its process; else a point of it *)
}

val name : t -> int * int
(** Leaf and index: what tells a part from all others. *)

val velocity : t -> Vec.t
(** Of the centre. *)

val turns : t -> bool
(** The spin of its process is not zero. *)

val relative_velocity : t -> t -> Vec.t
(** The velocity of the second less that of the first: of bodies that do not turn, that of all their points. *)

val in_relative_motion : t -> t -> bool
(** Whether they are of two processes that move against each other: no others ever collide. *)

val move_alike : t array -> bool
(** No two of them are in relative motion. *)

val reach : t -> Rat.t
(** An upper bound on the distance of its points from the centre; turning does not change it. *)
