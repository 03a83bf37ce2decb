(** The Aldebaran format of labelled graphs, as CADP, mCRL2, merc and [scc explore] write it:

    {v
      des (0, 2, 3)
      (0, "time(1/2)", 1)
      (1, tau, 2)
    v}

    A header with the initial state, the number of transitions and the number of states; then one transition to a
    line, with quotes around the label or without. [tau] and [i] are the silent action. A transition [unexplored]
    says that not all transitions of its source are known; it is no transition itself. Empty lines are skipped. At
    most 200 million states. *)

open Scc_base

val read : file:string -> string -> (Graph.t, Diag.t) result
(** SC0803, at its place, for what does not fit. The states keep their numbers. *)

val write : ?cadp:bool -> Graph.t -> (string -> unit) -> unit
(** Piece by piece. Silent labels are ["tau"], or [i] without quotes with [cadp] (off by default); unknown states
    get a loop ["unexplored"]. *)
