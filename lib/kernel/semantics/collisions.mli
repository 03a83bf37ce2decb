(** Collisions of processes (rule Collision), which end in rule Bind or rule Bounce. *)

open Scc_exact
open Scc_calculus

val parts : Semantics.t -> State.process array -> Part.t array
(** In the order of processes, leaves and parts. *)

val meetings : Semantics.t -> State.process array -> Kinematics.meeting list
(** Every two processes that collide, in order; and, where contact is enough to bind (reading I-33), every two that
    have a candidate. *)

val colliding : Semantics.t -> State.t -> (int * int) list
(** Which two processes do, by their indices. *)

val collides : Semantics.t -> State.t -> bool
(** Whether any two do. *)

(** A bond that two leaves may make, with what becomes of them, and by which summands. *)
type candidate = {
  bond : State.bond;
  continuations : (int * Behaviour.t) list;
  fired : Behaviours.derivation list list;
}

val fitting :
  Semantics.t -> State.process * int -> State.process * int -> (Behaviour.channel * Behaviour.channel) list
(** All two channels that are open and compatible, one of each of two leaves, given with their processes. *)

val bonds : Semantics.t -> Part.t * Part.t -> candidate list
(** By all channels of the leaves of two parts that are open and compatible, in all pairs of features of the
    highest dimension in which the two parts touch and which the channels share (rules Bind and Close). *)

(** What is resolved at once. *)
type cluster = {
  members : int list;  (** indices of processes, in order *)
  meetings : Kinematics.meeting list;  (** of two members each; not empty *)
}

val clusters : Semantics.t -> State.process array -> cluster list
(** One for each meeting (reading I-8); or, where collisions are resolved together, meetings that hang together
    by a process that is not fixed are one cluster (reading I-32). In the order of their first meetings. *)

val outcomes : Semantics.t -> State.process array -> cluster -> (Transition.outcome list, Transition.fault) result
(** Rule Bind: one for each candidate, of all pairs of parts that touch (reading I-12). Without candidates rule
    Bounce: one, or the fault of rule Persistent. *)

val first_time_of_contact : Semantics.t -> State.process array -> limit:Rat.t option -> Rat.t option
(** The least time at which two processes meet ({!meetings}), if there is one that is at most the limit; of
    processes that do not meet now. *)
