(** A run that does otherwise than the run of a verdict, and parts from it as late as possible. Where all runs were
    to come to g and one does not, it is a run that does come to g. Both together show which step decides. *)

type t = {
  run : Run.t;
  shared : int;  (** the number of steps that it has in common with the other run, at its beginning *)
}

val find : Eval.t -> Timed_formula.t -> Run.t -> holds:bool -> t option
(** [find e f run ~holds] is the run for the top operator of [f]: "all" that does not hold, or "some" that does
    ([holds]), as [run] shows, which begins at a node. [None] if no run does otherwise, or none is known, or the
    operator is another one. *)

val explain : Eval.t -> Explanation.t -> (Explanation.t * int) option
(** [explain e x] is the run that does otherwise than the one of [x], with reasons for its end, as an explanation
    of the opposite of [x]; and how many steps the two share. [None] if [x] has no run of its own, or {!find} finds
    none. *)
