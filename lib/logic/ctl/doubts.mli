(** Why a formula is undecided at a position. *)

type undefined = { predicate : int; position : Positions.position; reason : string }

type t = {
  unexplored : int list;
  (** the nodes that are not known and matter, increasing: reached through positions at which the sub-formulas
      are undecided, and in time. Some of them may turn out not to matter once others are known. *)
  undefined : undefined list;
  (** predicates that are undecided where it matters, each predicate and reason once *)
}

val possible : Eval.t -> Formula.t -> Positions.position -> t
(** Whether or not it is decided there: what keeps a probability that it asks for from being known. *)

val find : Eval.t -> Formula.t -> Positions.position -> t
(** All empty where it is decided, and only there. *)
