(** Contact within resolution along a trajectory (rule Instants in the rigid calculus). Two bodies touch at an
    instant iff some part of one is at most the resolution away from some part of the other. *)

open Scc_ctl
open Scc_exact
open Scc_motion

val touching : resolution:Rat.t -> Timeline.extent -> Path.t * int -> Path.t * int -> Truth.t Timeline.t
(** [touching ~resolution extent (p, i) (q, j)] is true when leaf [i], on the path [p], touches leaf [j], on the
    path [q]. The paths may be of one process; the model is rigid. At an instant the distance is exact. Over a
    piece of a trajectory it follows from the distance in the middle and a bound on the speeds. The result is
    undecided where the distance differs from the resolution by less than resolution / 32, for about the time in
    which it may change by as much. *)
