(** Runs that decide the operators: with the fewest steps, or the earliest or latest if there is a bound of time.
*)

val some : Eval.t -> Eval.until -> Positions.position -> Run.t
(** [some e u p] is a run to a position ({!Run.goal}) at which g holds, for u = E(f U g) that surely holds at [p]
    (a bug otherwise). *)

val every : Eval.t -> Eval.until -> Positions.position -> Run.t
(** [every e u p] is a run without g, for u = A(f U g) that surely does not hold at [p] (a bug otherwise). It is
    endless, or leads to a position at which f does not hold. There g does not hold either, unless an open interval
    begins on which f fails. *)

val next : Eval.t -> holds:(int -> bool) -> leads:(int -> bool) -> Positions.position -> Run.t
(** [next e ~holds ~leads p] is a run from [p] through flows, then by one edge to a node that passes [holds].
    [leads] is true for the nodes from which there is such a run; it is a bug if there is none. *)
