(** Bounds on an exploration of zones, and the truncations for them. *)

open Scc_verify

val default_depth : int
(** The bound on the depth if none is given: 1 000 transitions. There is always a bound on depth. *)

val depth : Bounds.t -> Verdict.truncation
(** The truncation by the bound on the depth: the given one, or {!default_depth}. *)

val states : Bounds.t -> Verdict.truncation
(** The truncation by the bound on the number of states. It is a bug if there is none. *)
