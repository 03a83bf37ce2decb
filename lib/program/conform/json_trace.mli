(** Traces as JSON Lines, in the format of [scc trace], in which members may be left out and floats are
    allowed. *)

open Scc_base

val read : Source.t -> (Recorded.t, Diag.t list) result
(** Reads a trace. The first line that does not fit is SC0804. *)
