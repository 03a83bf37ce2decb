(** The axes of two turning solids in floats: those that can separate at an instant, and a guess of those that
    do so for long. Each bound on errors has its proof in the code. *)

open Scc_exact

type t

val make : Axis.pair -> t
(** The floats for a pair of motions. *)

val candidates : t -> low:Rat.t -> high:Rat.t -> Axis.t Seq.t
(** [candidates g ~low ~high], for 0 <= low <= high <= 1, has all axes except those proved not to separate
    anywhere in [low, high]. The most promising come first; this order is a guess. *)

val holds : t -> Axis.t -> int -> low:Rat.t -> bool
(** [holds g axis i ~low] is true if it is proved that condition [i] of the axis holds from [low] to 1. *)
