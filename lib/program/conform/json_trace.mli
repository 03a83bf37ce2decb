(** Traces as JSON Lines: what [scc trace] writes, with members left out and floats allowed. *)

open Scc_base

val read : Source.t -> (Recorded.t, Diag.t list) result
(** SC0804 at the first line that does not fit. *)
