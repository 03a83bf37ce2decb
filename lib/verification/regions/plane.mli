(** A plane of two parameters, or a line of one, divided by the outcomes of several checks. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus

type view = private {
  across : int;  (** the parameter from left to right *)
  up : int option;  (** that from below; none for a line *)
  fixed : (int * Rat.t) list;  (** the values of other parameters; those that are neither shown nor fixed are
                                   projected *)
}

val view :
  Ranges.t -> axes:string list -> fixed:(string * Rat.t) list -> (view, string) result
(** The view of the one or two parameters in [axes]; if [axes] is empty, of the first ones that are not fixed.
    The error, in words, is one of these: a parameter that does not exist, no parameter at all, a parameter
    named twice, or a value out of its range. *)

val hidden : Ranges.t -> view -> int list
(** The parameters that are projected. *)

type outcome =
  | Holds
  | Varies  (** for some values of the projected parameters it holds or is one number, and not so for others *)
  | Unknown
  | Fails
  | Value of int  (** of a probability: its number among {!Chances.t.parts} *)

type region = {
  outcomes : outcome list;  (** of the checks, in their order, and then of the probabilities *)
  set : Union.t;  (** in the plane, by pieces as {!Where.tidy} gives; a line is one of height 1, from 0 to 1 *)
  share : Rat.t;  (** of its area in that of the ranges shown *)
}

val regions : ?values:Chances.t list -> Ranges.t -> view -> Where.t list -> region list
(** All regions that are not empty. They are disjoint and cover the ranges shown. The checks, and the probabilities
    in [values], have these ranges. *)
