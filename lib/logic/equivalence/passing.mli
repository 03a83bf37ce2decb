(** Graphs in which time passes, by labels that {!Label.val-passing} recognises. *)

val merge : Graph.t -> Graph.t
(** [merge g] is the graph in which consecutive passings of time are merged into one, since time is additive
    ([time(1).time(2) = time(3)]). A state whose only move is one passing of time is skipped. A path on which time
    passes for ever and nothing else can happen becomes [time(forever)], to a state whose only move is that. Silent
    loops, and loops of other labels, count as moves.

    The initial state stays, and becomes state 0. States that cannot be reached any more are dropped. Labels of
    equal durations become one label. *)

val deterministic : Graph.t -> bool
(** [deterministic g] is true if no state has two edges that pass time. *)

val hide : Graph.t -> Graph.t
(** [hide g] is the graph in which each passing of time is silent. *)

val without_durations : Graph.t -> Graph.t
(** [without_durations g] is the graph in which each passing of time is the action [time]. *)
