(** The range of a number that is read off a state, whatever the run: known before any run is made. *)

open Scc_exact
open Scc_calculus
open Scc_property

(** A range of rational numbers. *)
type t = {
  low : Rat.t;
  high : Rat.t;  (** at least [low] *)
  ends_only : bool;  (** the number is one of the two, and never between them *)
}

val of_number : Model.t -> time:Rat.t -> Property.num -> t option
(** The range of the number at this time, by its form alone. Counts have ranges, and numbers of bonds, processes
    and shapes, and expressions of these. It is [None] for others: positions, velocities and momenta may be any
    numbers. *)
