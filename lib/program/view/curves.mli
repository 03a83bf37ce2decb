(** Numbers over time, for plots. *)

open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_ctl

val of_checks : Property.check list -> Property.num list
(** The numbers that the checks name and that change while time passes: in order, each once, at most 8. *)

val value : Semantics.t -> State.t -> Timeline.extent -> Property.num -> Scc_runs.Curve_json.t
(** The number over time from a state on, while nothing happens, as by {!Curve_json.number}. *)
