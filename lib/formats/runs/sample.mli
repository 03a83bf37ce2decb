(** The start of a run of a model whose parameters have ranges. *)

open Scc_exact
open Scc_calculus

(** How values are chosen from ranges. *)
type how =
  | Simple  (** {!Scc_calculus.Ranges.point} *)
  | Random of int64
  (** by SplitMix64 from this seed: each parameter, in the order of the ranges, gets one of the 1023 values that
      divide its range into 1024 equal parts, each equally likely *)

val values : how -> Ranges.t -> (string * Rat.t) list
(** A value for each parameter, in its range and not at an end of it. Those of a seed are independent of the
    choices that {!Replay} makes by the same seed. *)

val to_string : (string * Rat.t) list -> string
(** The values as a text, such as ["y = 1/2, z = 0"]. *)
