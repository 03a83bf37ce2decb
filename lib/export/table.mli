(** Numbers and truths of the states of a run as a table (CSV, RFC 4180): a line for each state, with the time, the
    event that led to it, and each observable, exactly and, in the column behind it, as a float (empty where there
    is none so great). *)

open Scc_exact
open Scc_property
open Scc_motion

type observable = { text : string;  (** as it was asked for *) what : what }
and what = Number of Property.num | Truth of Property.prop

val file : Film.t -> Course.t -> observable list -> every:Rat.t option -> (string -> unit) -> unit
(** The states of the run, the initial one and the one after each transition; or with [every] those at its
    multiples, and at the end. What has no value is left empty. A truth is [true] or [false], as a float 1 or 0. *)
