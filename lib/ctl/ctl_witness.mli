(** Runs that decide the operators: shortest in steps, or earliest or latest where there is a bound of time. *)

val some : Ctl_eval.t -> Ctl_eval.until -> Ctl_set.position -> Ctl_run.t
(** Of E(f U g) that surely holds at the position: to a position ({!Ctl_run.goal}) at which g holds. *)

val every : Ctl_eval.t -> Ctl_eval.until -> Ctl_set.position -> Ctl_run.t
(** Of A(f U g) that surely does not hold at the position: to a position at which f does not hold, with no g
    before (nor there, but for open intervals on which f fails from the beginning on), or without end. *)

val next : Ctl_eval.t -> holds:(int -> bool) -> leads:(int -> bool) -> Ctl_set.position -> Ctl_run.t
(** Through flows and by one edge, to a node that [holds]; [leads] says from which nodes there is one. *)
