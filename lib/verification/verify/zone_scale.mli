(** What a verdict over zones is about. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

val at_any_time : Model.t -> declared:State.t -> bool
(** Bonds may be released at any time, and some may be. *)

val leaves_open : Model.t -> declared:State.t -> bool
(** The model has parameters of which a range is known, or bonds that may be released at any time. *)

val make : Semantics.t -> declared:State.t -> example:(string * Rat.t) list -> by_invariant:bool -> Verdict.scale
