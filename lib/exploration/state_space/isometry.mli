(** Isometries of a scene: turns and mirror images of space, along its axes, under which nothing that a model says
    changes (rule Isometry). *)

open Scc_calculus
open Scc_property

type t
(** A map of space that takes each axis to an axis, and the middle of all fixed bodies to itself. *)

val find : Model.t -> initial:State.t -> predicates:Property.prop list -> numbers:Property.num list -> t list
(** [find m ~initial ~predicates ~numbers] is all such maps but the identity, in a fixed order, under which the
    following is unchanged: the fixed bodies of [initial] as a set, the shape of each other body, the laws of
    motion with their chances, the features that behaviours name, and each of the predicates and numbers. There is
    none where no body is fixed, a law is not constant, bodies turn, or velocities are rounded. Of maps that do the
    same to all bodies and velocities of [initial] and to all that laws give, one is in the list: none if that is
    what the identity does. *)

val image : t -> Model.t -> State.process -> State.process
(** [image g m p] is the process that [p] is in the image of its state under [g]. It has the same leaves, bonds and
    behaviours. Leaves that are fixed stay where they are. *)
