(** Collisions of the rigid calculus (rules Contact, Near and Ftoc for bodies that turn): for rigid models what
    {!Collision} is for translational ones. *)

open Scc_exact
open Scc_calculus

(** Two processes that collide, the one with the lesser index first. *)
type t = {
  first : int;
  second : int;  (** indices of processes *)
  parts : ((int * int) * (int * int)) list;
  (** leaf and part of each: the pairs that would interpenetrate at once; sorted, not empty *)
}

val colliding : Model.t -> State.t -> t list
(** Every two processes that collide: some pair of their parts first interpenetrates less than 2^-K from now, where
    K is the least number at which no gap between the two changes by more than the resolution meanwhile. Sorted. *)

val outcomes : Model.t -> State.t -> t -> (Collision.outcome list, Transition.fault) result
(** One for each binding candidate (rule Bind), or the bounce (rule Bounce). A fault when the bounce would change
    nothing: a persistent contact. *)

val first_time_of_contact : Model.t -> State.t -> limit:Rat.t option -> Rat.t option
(** The least time at which two processes collide, if there is one that is at most [limit], for a state in which
    none collide now: a multiple of 2^-K, before the bodies would interpenetrate by less than 2^-K. Without a limit
    nothing may be spinning. *)

val none_ahead : Model.t -> State.t -> bool
(** Whether it is proved that no two processes ever collide again, if nothing else happens to them: each stays in a
    straight prism, and those never meet. Then no two of which one spins are ever within the resolution of each
    other, now included. *)

val apart : Model.t -> State.t -> int -> by:Rat.t -> bool
(** Whether a process (by its index) is farther than a distance from every other one. *)
