(** Recorded traces from files. *)

open Scc_base

val trace : Source.t -> (Recorded.t, Diag.t list) result
(** Reads a trace: JSON Lines if the text begins with a brace, and CSV otherwise. A text that does not fit is
    SC0804. *)
