(** Verdicts of properties that are more than searches, from the graph of all owners. *)

open Scc_state_space
open Scc_verify

type t = {
  check : int;  (** its place among the checks of the header *)
  verdict : Verdict.t;  (** without runs; its reasons are truth values that could not be found *)
  unexplored : bool;  (** it is not known better since states were not expanded *)
}

val all : Wanted.t -> Formulas.t -> Progress.t -> most_states:int -> t list
(** [all wanted formulas progress ~most_states] is the verdicts of all that is wanted, in order. [formulas] are
    those of [wanted], on the graph. [progress] is how far the exploration came, of at most so many states. *)

val are_settled : Wanted.t -> Formulas.t -> bool
(** [are_settled wanted formulas] is true if no state that was not expanded matters to what is wanted. *)
