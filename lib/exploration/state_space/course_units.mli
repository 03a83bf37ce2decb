(** The parts of formulas whose truth may change while bodies move (rule JoinedDraws, steps in which nothing is
    seen). *)

open Scc_property

(** A part of a predicate. The leaves are those that it names, sorted. *)
type t = { prop : Property.prop; leaves : int list }

val of_checks : Property.check list -> t list option
(** [of_checks checks] is a set of units. Two states that differ in places and velocities alone agree on [checks]
    along two courses if each unit has the same truth along both. The result is [None] where this is not known: a
    mean reads a place directly, or a unit depends on the time or on the whole network. *)
