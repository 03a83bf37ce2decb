(** The range of a number that is read off a state, whatever the run: known before any run is made. *)

open Scc_exact
open Scc_calculus
open Scc_property

(** A range of rational numbers. *)
type t = {
  low : Rat.t option;  (** [None]: no least value is known *)
  high : Rat.t option;  (** [None]: no greatest value is known; else at least [low] *)
  ends_only : bool;  (** both ends are known, the number is one of the two, and never between them *)
}

val never_negative : t
(** 0 and all that is above. *)

val of_number : Model.t -> from:State.t option -> time:Rat.t -> Property.num -> t
(** The range of the number at this time, in runs that begin in the state [from] (law {e Ranges} of the rule book).
    Counts have ranges, numbers of bonds, processes and shapes, and expressions of these. Squares and energies are
    never negative. Positions, velocities, momenta, distances and energies have ranges where a bound on all
    speeds is known ({!Scc_state_space.Pace.speeds}); without [from] they have none. In [if p then a else b], a
    term that [p] compares with another one is in the range that [p] leaves to it; so [min], [max] and [abs] have
    ranges. *)

val both : t -> (Rat.t * Rat.t) option
(** The two ends, if both are known. *)

val is_unknown : t -> bool
(** [is_unknown t] is true if no end is known. *)
