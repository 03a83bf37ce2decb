(** The results of many runs as a chart: the mean of each observable over time, in a band between the first and
    the last of the quantiles. *)

open Scc_exact

val chart : Report.t -> quantiles:Rat.t list -> Report.summary -> string
(** An SVG document with a panel for each observable. *)
