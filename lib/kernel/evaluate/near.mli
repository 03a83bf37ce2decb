(** Contact within resolution along a trajectory (rule Instants in the rigid calculus): two bodies touch at an
    instant iff the distance of some part of one from some part of the other is at most the resolution. *)

open Scc_ctl
open Scc_exact
open Scc_motion

val touching : resolution:Rat.t -> Timeline.extent -> Path.t * int -> Path.t * int -> Truth.t Timeline.t
(** Of two leaves of one process, or of two, of a rigid model. The distance is exact at an instant. Over a piece
    of a trajectory it is known from that in the middle and a bound on the speeds; where the distance is within a
    thirty-second of the resolution from the resolution itself, for about as long as it takes to change so much,
    it is undecided. *)
