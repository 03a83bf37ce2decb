(** The scale of a verdict over zones. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

val at_any_time : Model.t -> declared:State.t -> bool
(** [at_any_time m ~declared] is true if bonds may be released at any time, and some behaviour may release
    one. *)

val leaves_open : Model.t -> declared:State.t -> bool
(** [leaves_open m ~declared] is true if the model has parameters with ranges, or bonds that may be released at
    any time. *)

val make :
  Semantics.t ->
  declared:State.t ->
  example:(string * Rat.t) list ->
  everywhere:bool ->
  by_invariant:bool ->
  Verdict.scale
(** The scale of a verdict over all values and instants that the model leaves open. The split step is that of
    its grid, if weak splits may happen. *)
