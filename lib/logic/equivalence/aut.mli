(** The Aldebaran format of labelled graphs, as CADP, mCRL2, merc and [scc explore] write it:

    {v
      des (0, 2, 3)
      (0, "time(1/2)", 1)
      (1, tau, 2)
    v}

    The header has the initial state, the number of transitions and the number of states. Each further line has one
    transition, with or without quotes around the label. [tau] and [i] are the silent action. A line [unexplored]
    marks its source as a state whose transitions are not all known; it is no transition. Empty lines are skipped.
    A graph has at most 200 million states. *)

open Scc_base

val read : file:string -> string -> (Graph.t, Diag.t) result
(** [read ~file text] is the graph in [text], or SC0803 at the place that does not fit the format. [file] is the
    name for diagnostics. States keep their numbers. *)

val write : ?cadp:bool -> Graph.t -> (string -> unit) -> unit
(** [write ~cadp g put] passes the text of the graph to [put] piece by piece. Silent labels are ["tau"], or [i]
    without quotes with [cadp], which is off by default. States that are not fully known get a loop ["unexplored"].
*)
