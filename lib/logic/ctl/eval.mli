(** Timed CTL over a timed graph: for each formula the set of positions at which it surely holds, and the set of
    those at which it perhaps does.

    {1 Runs}

    A position is a node, or an offset strictly inside the flow of a node; the end of a flow is the node it
    leads to. A run goes from a node by one of its edges, in no time, or lets time pass through its flow, when
    it has one, to one of the targets; inside a flow nothing else can happen. It goes on as long as it can: it
    ends at a dead end, stays in a flow that lasts for ever, or takes infinitely many transitions, whether or not
    time goes on and on (rule Run). No fairness is assumed.

    {1 Operators} (rule Next, rule Until, rule Intervals)

    - EX f: some run takes an edge at last, if need be after time has passed, and f holds where its first edge
      leads. AX f is not EX not f, so that it holds where no run takes any edge.
    - E(f U[a,b] g): some run has a position at which g holds and the elapsed time is in [a, b], and f holds at
      all its positions before. Where an open interval of a flow begins there is no first position: to meet g by
      going into one, f must hold there as well. A(f U g): every run does.
    - F g is (true U g); G f is not F not f, with the other quantifier.

    {1 Three values} (rule Truncated)

    The lower set takes what is not known for false (from the point of view of the formula: under "not" for
    true), the upper one for true: what follows nodes that are not known, and predicates that are undecided. *)

type predicates = {
  at : int -> int -> Truth.t;  (** predicate and node *)
  along : int -> int -> Timeline.extent -> Truth.t Timeline.t;
  (** predicate and a node that is known, with the extent of its flow *)
  steady : int -> bool;
  (** the predicate is the same along the flow of each node as in the node; [along] is not asked *)
}

type t

val create : ?effort:Scc_chance.Effort.t -> Timed_graph.index -> predicates -> t
(** Sub-formulas are evaluated once for all formulas that are asked. The effort is that for probabilities. *)

val index : t -> Timed_graph.index
val graph : t -> Timed_graph.t
val effort : t -> Scc_chance.Effort.t
val predicates : t -> predicates

type value = { lower : Positions.t; upper : Positions.t  (** physically the lower one when nothing is in doubt *) }

val value : t -> Formula.t -> value
type uses
(** Of formulas that are asked about one after the other. *)

val uses : Formula.t array -> uses

val done_with : t -> uses -> int -> unit
(** After the formula of this number, and after each before it: forgets the values of what is no part of a later
    one, as they take memory for each state. *)

val truth : t -> Formula.t -> Positions.position -> bool option
(** [None]: undecided. *)

(** A probability; where not all is known, what it is not below, and what it is not above. *)
type measured = { least : Scc_chance.Answer.t; most : Scc_chance.Answer.t }

val probability : t -> decide:bool -> Formula.side -> Formula.t -> Positions.position -> measured
(** Of an operator F, G or U, whatever its quantifier: the probability that a run from there does as it says. To
    [decide] is to stop as soon as the test of that quantifier is. *)

(** {1 The one operator behind F, G and U} *)

type until = {
  quantifier : Formula.quantifier;
  bound : Formula.bound;
  left : Formula.t;
  right : Formula.t;
}

val as_until : Formula.t -> (until * bool) option
(** An F, G or U as an U, and whether its truth is the opposite of that. *)

val likely_run : t -> until -> Positions.position -> (Run.t * Scc_exact.Rat.t) option
(** Of an until with a probability, a run that surely satisfies it, of a scheduler that attains the probability
    ({!Likelihood.run}). *)
