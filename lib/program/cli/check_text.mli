(** The report of [scc check] for people. *)

open Scc_semantics
open Scc_explain
open Scc_verify

val property : Console.t -> full:bool -> ?where:Scc_regions.Where.t -> Semantics.t -> Verdict.outcome -> string
(** A verdict in several lines, with its witness; ended by a newline. Of the run what matters is told, in words
    that can be read: all of it if [full]. *)

val zeno : full:bool -> Semantics.t -> Witness.t -> string
(** A run that never leaves an instant. *)

val zeno_left_out : Verdict.truncation -> string
(** Of one that was not made. *)

val explored : Check.stats -> string
(** One line, and one for each fault. *)

val causes : Scc_calculus.Model.t -> Check.stats -> string
(** Why it is likely not to have closed, and what helps. *)

val slices : Check.slice list -> string
(** A line for each: who was left out for which properties, and what was explored without them. *)

val invariants : asked:bool -> Check.report -> string
(** A line for each invariant that was found; where one was asked for and none was found, why not. *)

val tally : Console.t -> Verdict.t list -> string
(** ["4 properties: 3 hold, 1 violated"]. *)
