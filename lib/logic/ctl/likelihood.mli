(** Probabilities of "f until g", within a window of time, over all schedulers: the least and the greatest (rule
    Probability).

    A timed graph with draws is a Markov decision process. In a node in which something is drawn the one choice is
    to draw. In any other a scheduler chooses one of the edges, or to let time pass, and if it passes into several
    nodes, into which. Where there is nothing to choose the run is over, and has not met g. A scheduler may
    remember all that has happened; what it needs of that is the time that has passed, which becomes a part of the
    states where there is a bound of time (and nothing else does). *)

open Scc_exact
open Scc_chance

type question = Decisions.question = {
  graph : Timed_graph.t;
  side : Formula.side;
  bound : Formula.bound;
  f : Positions.t;
  g : Positions.t;
  generous : bool;
  (** Nodes of which it is not known what follows them satisfy what they can when it is true, and nothing
      otherwise: for a number that the probability is not above, and for one that it is not below. *)
}

val at : question -> Effort.t -> Positions.position -> Answer.t
(** From this position on. *)

val set : question -> Effort.t -> (Answer.t -> bool) -> Positions.t
(** The positions from which on the probability passes the test. *)

val run : question -> Effort.t -> Positions.position -> (Run.t * Rat.t) option
(** Of a scheduler that attains the probability, a run to g with as few steps as can be, and the probability that
    it comes to be that one; [None]: the probability is 0, or nothing is known of it but bounds. *)
