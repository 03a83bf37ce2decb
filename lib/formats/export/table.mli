(** Numbers and truths of the states of a run as a table (CSV, RFC 4180): a line for each state, with the time, the
    event that led to it, and each observable, exactly and, in the column behind it, as a float (empty where there
    is none so great). *)

open Scc_exact
open Scc_calculus
open Scc_property
open Scc_semantics
open Scc_motion

type observable = { text : string;  (** as it was asked for *) what : what }
and what = Number of Property.num | Truth of Property.prop

val line : (string -> unit) -> string list -> unit
(** Fields in quotes where they need them, and the end of a line (RFC 4180). *)

val exact : Semantics.t -> observable -> State.t -> Rat.t option
(** Of a state that nothing has just led to: the number, or 1 or 0 for a truth, if it has a value there. *)

(** What has no value is left empty. A truth is [true] or [false], as a float 1 or 0. *)

(** {1 The initial state, and the one after each transition} *)

type lines

val start : Semantics.t -> observable list -> State.t -> lines
(** From the initial state on. *)

val leg : lines -> Course.leg -> unit
(** One after the other. *)

val finish : lines -> rest:Rat.t -> (string -> unit) -> unit
(** Writes the table, given how much time passes after the last leg. *)

(** {1 Other states} *)

val at : Course.t -> observable list -> Rat.t list -> (string -> unit) -> unit
(** Those at times of the run. *)
