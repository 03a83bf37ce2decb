(** The values of parameters with ranges for which checks hold, as a drawing in the plane of two parameters or
    on the line of one. *)

open Scc_exact
open Scc_calculus
open Scc_regions
open Scc_json

val json :
  Ranges.t -> Plane.view -> (string * Where.t) list -> samples:((string * Rat.t) list * int) list -> Json.t
(** The drawing for checks with their names. Each sample is a start, with the number of its run in the
    document. *)

val starts : Ranges.t -> Plane.view -> Where.t list -> (string * Rat.t) list list
(** Starts for runs: one in each piece of each region, at most 200, and some on a grid over the ranges. Each has
    a value for every parameter. Parameters that are not shown have the value that the view fixes, or that of
    {!Ranges.point}. *)
