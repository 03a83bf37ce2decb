(** The atom [touching] along paths (rule Instants). *)

open Scc_ctl
open Scc_semantics
open Scc_motion

val along : Semantics.t -> int -> int -> Timeline.extent -> Path.t -> Path.t -> Truth.t Timeline.t
(** [along semantics i j extent p q] is true when leaf [i], of the process on the path [p], touches leaf [j], of
    the process on the path [q]. The leaves must differ. In the translational calculus two parts touch during a
    closed interval, which is exact: they never interpenetrate along a trajectory, so meeting is touching. In the
    rigid calculus it is {!Near.touching}. *)
