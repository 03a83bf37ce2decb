(** The values of parameters with ranges for which checks hold, and probabilities as functions of these values: a
    drawing in the plane of two parameters or on the line of one. *)

open Scc_exact
open Scc_calculus
open Scc_regions
open Scc_json

(** The drawing for checks and probabilities with their names. *)
type t = {
  ranges : Ranges.t;
  view : Plane.view;
  checks : (string * Where.t) list;
  numbers : (string * Chances.t) list;
  drawn : Plane.region list;  (** their regions, as {!drawn} gives *)
  samples : ((string * Rat.t) list * int) list;  (** starts, with the numbers of their runs in the document *)
}

val drawn :
  Ranges.t ->
  Plane.view ->
  checks:(string * Where.t) list ->
  numbers:(string * Chances.t) list ->
  Plane.region list
(** The regions in which all checks and all numbers have one outcome. *)

val format : (t, unit) Json_format.t
(** The format of the drawing. Each region is there with its constraints, and as polygons to be painted. *)

val starts : Ranges.t -> Plane.view -> Plane.region list -> (string * Rat.t) list list
(** Starts for runs: one in each piece of each region, at most 200, and some on a grid over the ranges. Each has
    a value for every parameter. Parameters that are not shown have the value that the view fixes, or that of
    {!Ranges.point}. *)
