(** The least and the greatest probability of "f until g" within a window of time, over all schedulers (rule
    Probability).

    A timed graph with draws is a Markov decision process. A node with a draw has one choice: to draw. In any other
    node a scheduler chooses an edge or the flow, and one of the targets of the flow. At a node without edges and
    flow the run is over, and has not met g. A scheduler may depend on the whole past. Of that only the elapsed
    time matters, which becomes a part of the states if there is a bound of time. *)

open Scc_exact
open Scc_chance

type question = Decisions.question = {
  graph : Timed_graph.t;
  side : Timed_formula.side;
  bound : Timed_formula.bound;
  f : Positions.t;
  g : Positions.t;
  generous : bool;
  (** The value of nodes whose successors are not known. With [true] they satisfy f until g if they can, for an
      upper bound of the probability. With [false] they do not, for a lower bound. *)
}

val at : question -> Effort.t -> Positions.position -> Answer.t
(** [at q effort p] is the probability from position [p] on. *)

val at_both : question -> question -> Effort.t -> Positions.position -> Answer.t * Answer.t
(** [at_both low high effort p] is {!at} of both questions, which differ in how they take what is not known. Where
    nothing of that matters without a bound of time, it is solved once. *)

val within : question -> Effort.t -> Decisions.window -> Decisions.next list -> Decisions.next -> Answer.t
(** [within q effort w starts] is the probability from each of [starts]. It solves the question once. *)

val set : question -> Effort.t -> (Answer.t -> bool) -> Positions.t
(** [set q effort test] is the positions from which on the probability passes the test. *)

val run : question -> Effort.t -> Positions.position -> (Run.t * Rat.t) option
(** [run q effort p] is a run from [p] to g with the fewest steps, of a scheduler that attains the probability, and
    the probability of this run. It is [None] if the probability is 0, and may be [None] if only bounds of it are
    known. *)
