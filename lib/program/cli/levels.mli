(** The option [--levels] of [scc estimate]: what is split, and where (rule book, Splitting). *)

open Scc_base
open Scc_property
open Scc_loading
open Scc_estimate

val refused : Property.check -> string -> Diag.t list
(** [refused check why] is the error that [check] cannot be estimated. *)

val plan :
  Console.t ->
  Loaded.t ->
  Path.t list ->
  string ->
  effort:int ->
  steps:int ->
  (Path.t * Splitting.plan, Diag.t list) result
(** [plan console model paths text ~effort ~steps] splits on the levels of [text] on the way to the goal of the one
    path of [paths], in [model]. It is an error if there are several paths, if the path has no goal, if [text] does
    not compare a number with rising values, and if a level or the goal is reached at the start. [effort] is the
    number of runs from each level, and [steps] how many transitions each of them has at most. *)
