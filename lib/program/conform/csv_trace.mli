(** Traces as CSV: a header that names the columns, then a row for each event or state of a body. *)

open Scc_base

val read : Source.t -> (Recorded.t, Diag.t list) result
(** Reads columns [time] and [event], and, in any order, [bodies], [channel], [features], [x], [y], [z], [vx],
    [vy], [vz], [behaviour]. Each row that does not fit is SC0804, up to 20 of them. *)
