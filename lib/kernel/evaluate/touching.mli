(** The atom [touching] along paths (rule Instants). *)

open Scc_ctl
open Scc_semantics
open Scc_motion

val along : Semantics.t -> int -> int -> Timeline.extent -> Path.t -> Path.t -> Truth.t Timeline.t
(** [along semantics i j extent p q], i and j different: when the leaf i, of the process on the path p, touches the
    leaf j, of that on the path q. In the translational calculus that is a closed interval for each pair of parts,
    found exactly (they never interpenetrate along a trajectory, so that meeting is touching); in the rigid one,
    {!Near}. *)
