(** Runs that decide the operators: shortest in steps, or earliest or latest where there is a bound of time. *)

val some : Eval.t -> Eval.until -> Positions.position -> Run.t
(** Of E(f U g) that surely holds at the position: to a position ({!Run.goal}) at which g holds. *)

val every : Eval.t -> Eval.until -> Positions.position -> Run.t
(** Of A(f U g) that surely does not hold at the position: to a position at which f does not hold, with no g
    before (nor there, but for open intervals on which f fails from the beginning on), or without end. *)

val next : Eval.t -> holds:(int -> bool) -> leads:(int -> bool) -> Positions.position -> Run.t
(** Through flows and by one edge, to a node that [holds]; [leads] says from which nodes there is one. *)
