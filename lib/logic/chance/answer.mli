(** Results for a probability or an expected reward: the exact value, or an interval that is proved to contain it.
*)

open Scc_exact

type t =
  | Exact of Rat.t
  | Within of Rat.t * Rat.t  (** at least the first and at most the second, which is not less *)
  | At_least of Rat.t  (** a finite reward of at least this, without a known upper bound *)
  | Infinite  (** an infinite reward *)

type relation = Less | At_most | At_least_so | More

(** A condition on a value: the value stands in [relation] to [than]. *)
type bound = { relation : relation; than : Rat.t }

val compare_bound : bound -> bound -> int
(** A total order of bounds: by relation, then by number. *)

val bound_to_string : bound -> string
(** [bound_to_string b] is e.g. [">= 1/2"]. *)

val add : t -> Rat.t -> t
(** [add a x] is the result for the value plus [x]; [x] may be negative. *)

val complement : t -> t
(** [complement a] is the result for 1 - p, where [a] is the result for a probability p. [At_least] and [Infinite]
    are bugs. *)

val holds : t -> bound -> bool option
(** [holds a bound] is the truth of the bound for the value; [None] if the interval does not decide it. *)

val lower : t -> Rat.t option
(** [lower a] is the lower bound of the value; [None] if it is infinite. *)

val upper : t -> Rat.t option
(** [upper a] is the upper bound of the value; [None] if none is known, or if it is infinite. *)

val contains : t -> Rat.t -> bool
(** [contains a x] is true if the value may be the number [x], by its bounds. *)

val to_string : t -> string
(** [to_string a] is ["1/3"], ["in [1/4, 1/2]"], ["at least 7"] or ["infinite"]. *)
