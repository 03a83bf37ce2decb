(** The basic shapes of a state as the rules of contact see them: each where it stands and on its way. *)

open Scc_exact
open Scc_rigid

type t = {
  process : int;  (** index of its process in the state *)
  leaf : int;
  index : int;  (** of the part in the leaf *)
  placed : Placed.t;  (** where it is now, in the world *)
  motion : Motion.t;  (** where it goes while nothing happens *)
}

val name : t -> int * int
(** Leaf and index: what tells a part from all others. *)

val relative_velocity : t -> t -> Vec.t
(** That of the process of the second less that of the process of the first: of bodies that do not turn, the
    relative velocity of all their points. *)

val in_relative_motion : t -> t -> bool
(** Whether they are of two processes that move against each other: no others ever collide. *)

val reach : t -> Rat.t
(** An upper bound on the distance of its points from the centre that it turns about; turning does not change it. *)
