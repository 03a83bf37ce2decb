(** Why a formula is undecided at a position. *)

type undefined = { predicate : int; position : Positions.position; reason : string }

type t = {
  unexplored : int list;
  (** The nodes that are not known and matter, increasing. They are reached in time, through positions at which the
      sub-formulas are undecided. Some of them may turn out not to matter once others are known. *)
  undefined : undefined list;
  (** Predicates that are undecided at positions that matter, each predicate and reason once. *)
}

val possible : Eval.t -> Timed_formula.t -> Positions.position -> t
(** [possible e f p] is as {!find}, but also if [f] is decided at [p]: it shows why a probability in [f] is not
    known exactly. *)

val find : Eval.t -> Timed_formula.t -> Positions.position -> t
(** [find e f p] is the reasons why [f] is undecided at [p]. Both lists are empty iff [f] is decided there. *)
