(** Collisions of two processes (rule Collision), which end in rule Bind or rule Bounce. *)

open Scc_exact
open Scc_calculus

(** Two processes that collide, the one with the lesser index first. *)
type meeting = {
  first : int;
  second : int;  (** indices of processes *)
  touching : (Part.t * Part.t) list;  (** all pairs of their parts that are not {!Kinematics.Apart}: some of them approach *)
}

val parts : Semantics.t -> State.process array -> Part.t array
(** In the order of processes, leaves and parts. *)

val meetings : Semantics.t -> State.process array -> meeting list
(** Every two processes that collide, in order. *)

val colliding : Semantics.t -> State.t -> (int * int) list
(** Which two processes do, by their indices. *)

val collides : Semantics.t -> State.t -> bool
(** Whether any two do. *)

val outcomes : Semantics.t -> State.process array -> meeting -> (Transition.outcome list, Transition.fault) result
(** Rule Bind: one for each candidate, of all pairs of parts that touch (reading I-12). Without candidates rule Bounce: one, or the fault of rule
    Persistent. *)

val first_time_of_contact : Semantics.t -> State.process array -> limit:Rat.t option -> Rat.t option
(** The least time at which two processes collide, if there is one that is at most the limit; of processes that do
    not collide now. *)
