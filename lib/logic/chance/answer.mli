(** What is known of a probability, or of an expected reward: itself, or an interval that it is proved to be in. *)

open Scc_exact

type t =
  | Exact of Rat.t
  | Within of Rat.t * Rat.t  (** at least the first and at most the second, which is not less *)
  | At_least of Rat.t  (** of a reward, which is finite: nothing is known above *)
  | Infinite  (** of a reward *)

type relation = Less | At_most | At_least_so | More

(** A question that a value answers: whether it stands in the relation to a bound. *)
type bound = { relation : relation; than : Rat.t }

val compare_bound : bound -> bound -> int
(** A total order. *)

val bound_to_string : bound -> string
(** [">= 1/2"]. *)

val add : t -> Rat.t -> t
(** So much more, or less. *)

val complement : t -> t
(** Of a probability: 1 minus it. *)

val holds : t -> bound -> bool option
(** Of the value: [None] where what is known of it does not tell. *)

val lower : t -> Rat.t option
(** What it is at least; [None]: it is infinite. *)

val upper : t -> Rat.t option
(** What it is at most; [None]: that is not known, or it is infinite. *)

val contains : t -> Rat.t -> bool
(** Whether the value may be this number, as far as is known. *)

val to_string : t -> string
(** ["1/3"], ["in [1/4, 1/2]"], ["at least 7"] or ["infinite"]. *)
