(** The axes of two turning solids in floats: which of them can separate at an instant, and which promise to do
    so for long. What is proved here holds: each bound on errors has its proof in the code. *)

open Scc_exact

type t

val make : Axis.pair -> t

val candidates : t -> low:Rat.t -> high:Rat.t -> Axis.t Seq.t
(** For 0 <= low <= high <= 1: all axes but such as are proved not to separate anywhere in [low, high], the most
    promising first. Which come first is a guess. *)

val holds : t -> Axis.t -> int -> low:Rat.t -> bool
(** Whether it is proved that a condition of an axis holds from [low] to 1. *)
