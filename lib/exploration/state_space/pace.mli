(** How fast bodies may get, whatever happens to them: what {!Slice} knows of those under laws of motion.

    A law is {e bounded} when it looks at nothing but the mass of its leaf. So each velocity that it may give is
    known, and so is their greatest length; and it is never in error. When all laws are asked at once, nothing
    that has been a part of the motion before is left of a process all of whose leaves are under such laws: as
    it takes the mean of what they give, weighted by mass, and v.v is convex, its mass times v.v is at most the
    sum over its leaves of their masses times the squares of those lengths. Binds and bounces never add kinetic
    energy. So the same is a bound for a whole group of such processes from then on, however they meet; and
    before, it has what it began with.

    Energies are twice the kinetic energy, of all that is not fixed. *)

open Scc_exact
open Scc_calculus

type t
(** Of some processes together, which may meet each other, and nobody else. *)

val allows : Model.t -> bool
(** All laws are bounded, and all of them leave the velocity to chance, or none does. (As soon as somebody waits
    to draw, a law that leaves nothing to chance waits for its velocity as well: so there is an instant at which
    this body is where the others make it wait, and has the old velocity.) True without laws. *)

val of_process : Model.t -> State.process -> t
(** In a model that is {!allows}-ed. *)

val add : t -> t -> t

val driven : t -> bool
(** Some law moves a leaf of theirs, or may do so after a split: velocities change without collisions. *)

val energy : Model.t -> horizon:Rat.t option -> collide:bool -> t -> Rat.t option
(** Their energy is never more than this up to the horizon; [None]: nothing is known. Bodies under no law may
    take energy from those under laws each time these have been asked anew: of a mixture something is known only
    where collisions end no movement steps, so that laws are asked once in a timestep. [collide]: they may have
    collisions; where movement steps are those of single processes, nothing is known of bodies under laws that
    have, as one may pass energy on to another one just before its law is asked. *)

val may_draw : t -> bool
(** All of their leaves together draw among {!Law.most_outcomes} velocities at most, so that to ask them is no
    error, whatever they are bound to. *)

val may_release : Model.t -> State.process -> bool
(** It has two leaves at least, and an offer to release a bond is written in what they do or may come to. *)
