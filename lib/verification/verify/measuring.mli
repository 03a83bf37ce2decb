(** Questions for numbers, answered on an explored graph (rules Probability, Expectation). *)

open Scc_property
open Scc_state_space

val probability : Unsettled.t -> Temporal.t -> int -> Property.side list -> curve:bool -> Verdict.t
(** The verdict for the probability of the path formula with this index, for each of the sides. With [curve] also
    for all ends of its bound of time up to the given one. *)

val mean :
  Unsettled.t -> Temporal.t -> int -> Property.side list -> Property.mean -> Scc_chance.Answer.bound option ->
  Verdict.t
(** The verdict for the mean of a quantity until the formula with this index, that of the check, comes true.
    Compared with a bound, it holds or not. *)

val formula_doubts : Unsettled.t -> Temporal.t -> int -> Verdict.reason list
(** [formula_doubts r temporal i] is the reasons why formula [i] is undecided, at least one. They are what was not
    explored or has no value, or else the known intervals of the probabilities on which it directly depends. That
    the time was over is one more. *)

(** {1 As functions of a parameter}

    The verdicts of rule Parametric for formula [i]: functions of the parameter in this range. *)

val probability_function :
  Unsettled.t -> Temporal.t -> Temporal.sensitivity -> int -> Property.side list -> Scc_calculus.Ranges.range ->
  Verdict.t
(** The verdict of a question for a probability. *)

val mean_function :
  Unsettled.t -> Temporal.t -> Temporal.sensitivity -> int -> Property.side list -> Property.mean ->
  Scc_chance.Answer.bound option -> Scc_calculus.Ranges.range -> Verdict.t
(** The verdict of a question for a mean, or of a test of one. *)

val claim_function :
  Unsettled.t -> Temporal.t -> Temporal.sensitivity -> int -> Property.temporal -> Scc_calculus.Ranges.range ->
  Verdict.t
(** The verdict of a formula with tests of probabilities. *)
