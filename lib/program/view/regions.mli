(** For which values of the parameters with ranges the checks hold, as a drawing in the plane of two of them, or on
    the line of one. *)

open Scc_exact
open Scc_calculus
open Scc_regions
open Scc_exchange

val json :
  Ranges.t -> Plane.view -> (string * Where.t) list -> samples:((string * Rat.t) list * int) list -> Json.t
(** Of checks with their names. Each sample is a start, and the number of its run. *)

val starts : Ranges.t -> Plane.view -> Where.t list -> (string * Rat.t) list list
(** Starts to look at: one in each piece of each region, and some on a grid over the ranges. A value for each
    parameter; those that are not shown have the value of {!Ranges.point}, or that which the view fixes. *)
