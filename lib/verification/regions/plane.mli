(** A plane of two parameters, or a line of one, parted by which of several checks hold there. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus

type view = private {
  across : int;  (** the parameter from left to right *)
  up : int option;  (** that from below; none for a line *)
  fixed : (int * Rat.t) list;  (** the value of others; what is neither shown nor fixed is projected *)
}

val view :
  Ranges.t -> axes:string list -> fixed:(string * Rat.t) list -> (view, string) result
(** The one or two parameters to be shown; if [axes] is empty, the first ones that are not fixed. An error, in
    words, if there is no parameter of such a name or none at all, if one is named twice, or if a value is not in
    its range. *)

val hidden : Ranges.t -> view -> int list
(** The parameters that are projected. *)

type outcome =
  | Holds
  | Varies  (** it holds for some values of what is projected, and fails for others *)
  | Unknown
  | Fails

type region = {
  outcomes : outcome list;  (** of the checks, in their order *)
  set : Union.t;  (** in the plane, by pieces as {!Where.tidy} gives; a line is one of height 1, from 0 to 1 *)
  share : Rat.t;  (** of its area in that of the ranges shown *)
}

val regions : Ranges.t -> view -> Where.t list -> region list
(** All regions that are not empty. They are disjoint and cover the ranges shown. The checks have these ranges. *)
