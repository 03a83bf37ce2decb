(** What many runs come to, as a chart: over the time the mean of each observable, in a band between the first and
    the last of the quantiles. *)

open Scc_exact

val chart : Report.t -> quantiles:Rat.t list -> Report.summary -> string
(** An SVG document. *)
