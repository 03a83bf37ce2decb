(** Bounds on the speed of bodies, whatever happens to them. {!Slice} uses them for bodies under laws of motion.

    A law is {e bounded} if it depends on nothing but the mass of its leaf, and is without fault. So all
    velocities that it may give are known, and so is their greatest length.

    Take a process all of whose leaves are under bounded laws. When all laws are evaluated at once, its new
    velocity is the mean of the velocities that they give, weighted by mass. Nothing is left of its motion
    before. As v.v is convex, its mass times v.v is at most a sum over its leaves: mass times square of the
    greatest length. Binds and bounces never add kinetic energy. So the sum over a group of such processes bounds
    its energy from then on, however they meet. Before that, the group has the energy that it began with.

    Energies are twice the kinetic energy, of all that is not fixed. *)

open Scc_exact
open Scc_calculus

type t
(** The bounds of a group of processes, which may meet each other and no others. *)

val allows : Model.t -> bool
(** [allows m] is true if all laws of [m] are bounded, and either all of them leave the velocity to chance or
    none does; it is true without laws. Laws of both kinds are excluded for this reason: while a process waits to
    draw, a law without chance waits for its velocity as well. So at some instant its body still has the old
    velocity because of others. *)

val of_process : Model.t -> State.process -> t
(** The bounds of a single process, in a model for which {!allows} is true. A law that is not bounded is a bug. *)

val add : t -> t -> t
(** The bounds of two groups as one group. *)

val driven : t -> bool
(** [driven t] is true if a law moves a leaf of the group, or may do so after a split. Then velocities may change
    without collisions. *)

val energy : Model.t -> horizon:Rat.t option -> collide:bool -> t -> Rat.t option
(** [energy m ~horizon ~collide t] is an upper bound on the energy of the group up to the horizon; [None] if no
    bound is known. [collide] is true if the group may have collisions.

    Bodies under no law may take energy from bodies under laws, each time after these laws have been evaluated.
    So a group with both kinds has a bound only if no collision ends a movement step: then laws are evaluated
    once in a timestep. Where processes have movement steps of their own, bodies under laws that may collide have
    no bound. One such body may pass energy on to another just before its own law is evaluated. *)

val may_draw : t -> bool
(** [may_draw t] is true if all leaves of the group together draw among [Law.most_outcomes] velocities at most.
    Then their laws have no fault, whatever the leaves are bound to. *)

val may_release : Model.t -> State.process -> bool
(** [may_release m p] is true if [p] has at least two leaves, and a release of a bond is written in a behaviour
    of them, or in what it may become. *)

val speeds : Model.t -> State.t -> horizon:Rat.t -> Rat.t array option
(** [speeds m s ~horizon] is, for each leaf, an upper bound on the square of its speed in all runs from [s] up to
    the horizon (law {e Ranges} of the rule book). [None] if no bounds are known. *)
