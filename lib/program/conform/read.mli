(** Recorded traces from files. *)

open Scc_base

val trace : Source.t -> (Recorded.t, Diag.t list) result
(** JSON Lines when the text begins with a brace, else CSV. SC0804 when it does not fit. *)
