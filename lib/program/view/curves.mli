(** Numbers over time: what is plotted. *)

open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_ctl
open Scc_exchange

val of_checks : Property.check list -> Property.num list
(** The numbers that the checks name and that change while time passes, in order, each once; no more than 8. *)

val value : Semantics.t -> State.t -> Timeline.extent -> Property.num -> Json.t
(** From a state on, while nothing happens, as {!Curve_json.number} tells it. *)
