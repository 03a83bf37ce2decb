(** Collisions of processes (rule Collision), which end in rule Bind or rule Bounce. *)

open Scc_exact
open Scc_calculus

val parts : Semantics.t -> State.process array -> Part.t array
(** All parts of some processes, in the order of processes, leaves and parts. *)

val meetings : Semantics.t -> State.process array -> Kinematics.meeting list
(** All pairs of processes that collide, in order. Where contact is enough to bind (reading I-33), also the pairs
    that touch and have a candidate. *)

val colliding : Semantics.t -> State.t -> (int * int) list
(** The pairs of processes of a state that meet ({!val-meetings}), by their indices, the lesser one first. *)

val collides : Semantics.t -> State.t -> bool
(** [collides c s] is true if two processes of [s] meet ({!val-meetings}). *)

(** A bond that two leaves may make, the behaviours of the two leaves after it, and the summands that make it. *)
type candidate = {
  bond : State.bond;
  continuations : (int * Behaviour.t) list;
  fired : Behaviours.derivation list list;
}

val fitting :
  Semantics.t -> State.process * int -> State.process * int -> (Behaviour.channel * Behaviour.channel) list
(** All pairs of open and compatible channels, the first of one leaf and the second of another. Each leaf is given
    with its process. *)

val in_turn : ('a -> int) -> 'a list -> 'a list list
(** [in_turn dimension pairs] are the pairs of features that two channels share, in the order in which rule Bind
    looks for pairs that touch. The first of these lists that has some is all that bind: pairs of the highest
    dimension. No list is empty. *)

val bonds : Semantics.t -> Part.t * Part.t -> candidate list
(** The bonds that the leaves of two parts may make (rules Bind and Close), for all their open and compatible
    channels. The features of a bond are a pair in which the two parts touch and which the channels share. Of these
    pairs, only those of the highest dimension bind. *)

val may_react : Semantics.t -> State.process -> State.process -> bool
(** [may_react c p q] is true if a meeting of [p] and [q] might have {!candidates}, wherever they touch. *)

val candidates : Semantics.t -> State.process array -> Kinematics.meeting -> Transition.outcome list
(** What may come of a meeting by rules Bind and Absorb. *)

val blocked : Semantics.t -> State.process array -> Kinematics.meeting -> int list
(** The walkers that a meeting without candidates stops (rule Blocked), by their indices. A meeting that stops some
    is not resolved by rule Bounce. *)

val by_processes : ('a * (Part.t * Part.t)) list -> ('a * (Part.t * Part.t)) list list
(** Pairs of parts, each with something said about it, in groups: one for each two processes, in the order of their
    indices. *)

(** Meetings that are resolved at once. *)
type cluster = {
  members : int list;  (** indices of processes, in order *)
  meetings : Kinematics.meeting list;  (** each between two members; not empty *)
}

val clusters : Semantics.t -> State.process array -> cluster list
(** The clusters of some processes, in the order of their first meetings. By default each meeting is a cluster
    (reading I-8). Where collisions are resolved together, meetings that share a process that is not fixed are in
    one cluster (reading I-32). *)

val outcomes : Semantics.t -> State.process array -> cluster -> (Transition.outcome list, Transition.fault) result
(** What may come of a cluster. By rule Bind, there is one outcome for each candidate, over all pairs of parts that
    touch (reading I-12). A collision with an absorbing body is a candidate, too: rule Absorb. Without candidates
    there is one outcome by rule Bounce, or the fault of rule Persistent. *)

val first_time_of_contact : Semantics.t -> State.process array -> limit:Rat.t option -> Rat.t option
(** The least time from now at which two processes meet ([meetings]), if it is at most the limit; else [None]. The
    processes must not meet now. *)
