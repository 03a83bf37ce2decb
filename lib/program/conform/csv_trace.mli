(** Traces as CSV: a header that names the columns, then a row for each event or state of a body. *)

open Scc_base

val read : Source.t -> (Recorded.t, Diag.t list) result
(** Columns [time] and [event], and, in any order, [bodies], [channel], [features], [x], [y], [z], [vx], [vy],
    [vz], [behaviour]. SC0804 for each row that does not fit, up to twenty of them. *)
