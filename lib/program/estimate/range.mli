(** Where a number that is read off a state always is, whatever the run: what is known before any run is made. *)

open Scc_exact
open Scc_calculus
open Scc_property

type t = {
  low : Rat.t;
  high : Rat.t;  (** at least [low] *)
  ends_only : bool;  (** it is one of the two, and never between them *)
}

val of_number : Model.t -> time:Rat.t -> Property.num -> t option
(** Of the number at this time, by its form alone. Counts are in a range, as are numbers of bonds, of processes and
    of shapes, and what is made of such. [None]: nothing is known. Places, motions and momenta may be anything. *)
