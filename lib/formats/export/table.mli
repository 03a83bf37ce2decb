(** Numbers and truth values of the states of a run as a table (CSV, RFC 4180). Each state has a line with the
    time, the event that led to it, and each observable. Numbers are exact; the next column has them as floats,
    and is empty if a number is too great for that. *)

open Scc_exact
open Scc_calculus
open Scc_property
open Scc_semantics
open Scc_motion

(** A column of the table. *)
type observable = { text : string;  (** its heading *) what : what }
and what = Number of Property.num | Truth of Property.prop

val line : (string -> unit) -> string list -> unit
(** Writes fields, in quotes where they need them, and the end of a line (RFC 4180). *)

val exact : Semantics.t -> observable -> State.t -> Rat.t option
(** The value of an observable in a state, right after no event: the number, or 1 or 0 for a truth value. It is
    [None] if the observable has no value there. *)

(** A field without a value is empty. A truth value is [true] or [false], and 1 or 0 as a float. *)

(** {1 The initial state, and the one after each transition} *)

(** A table in the making. *)
type lines

val start : Semantics.t -> observable list -> State.t -> lines
(** A table with the line of the initial state. *)

val leg : lines -> Course.leg -> unit
(** Adds the line of the state after a transition. Legs are added in order. *)

val finish : lines -> rest:Rat.t -> (string -> unit) -> unit
(** Writes the table. [rest] is the time that passes after the last leg; if it is positive, its end has a line
    as well. *)

(** {1 Other states} *)

val at : Course.t -> observable list -> Rat.t list -> (string -> unit) -> unit
(** Writes the table of the states at these times of the run. *)
