(** Answers that depend on a parameter, in words (rule Parametric). *)

open Scc_calculus
open Scc_chance

(** A value as a function of the parameter. *)
type value = {
  pieces : Parametric.piece list;
  shape : Dependence.shape option;  (** [None] if it is infinite, or if there was too little time to find it *)
}

type values = (Scc_property.Property.side * value) list

val to_string : Ranges.range -> values:values -> holds:Dependence.set option -> string
(** [to_string range ~values ~holds] is an answer in one line: a function, or whether a claim holds for all
    values. *)

val lines : full:bool -> Ranges.range -> values:values -> holds:Dependence.set option -> string list
(** [lines ~full range ~values ~holds] is an answer in detail: where a claim holds, and each value with its
    derivative, where it rises and falls, and its extremes. Long functions are shortened, unless [full]. *)

val found : Ranges.range -> Parametric.found -> string list
(** [found parameter f] is what was found of a function that is not known: its pieces, and a few of its values, in
    words. *)
