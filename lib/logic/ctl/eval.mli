(** Timed CTL over a timed graph: for each formula the set of positions at which it surely holds, and the set of
    those at which it perhaps holds.

    {1 Runs}

    A position is a node, or an offset strictly inside the flow of a node; the end of a flow is the node to which
    it leads. A run leaves a node by one of its edges, in no time, or passes through its flow, if it has one, to
    one of the targets. Inside a flow nothing else can happen. A run goes on as long as it can (rule Run). It ends
    at a dead end, stays in a flow that lasts for ever, or takes infinitely many transitions, in bounded time or
    not. No fairness is assumed.

    {1 Operators}

    By rule Next, rule Until and rule Intervals:

    - EX f: some run takes an edge, possibly after time has passed, and f holds after its first edge. AX f is not
      EX not f, so it holds at a position from which no run takes an edge.
    - E(f U[a,b] g): some run has a position at which g holds and the elapsed time is in [a, b], and f holds at all
      its positions before. An open interval of a flow has no first position: to meet g by entering one, f must
      hold there as well. A(f U g): every run has such a position.
    - F g is (true U g); G f is not F not f, with the other quantifier.

    {1 Three values}

    By rule Truncated: unknown are the successors of nodes that are not known, and predicates that are undecided.
    The lower set takes unknown truth for false, and the upper set for true; under "not" it is the other way
    round. *)

type predicates = {
  at : int -> int -> Truth.t;  (** [at p s] is predicate [p] at node [s] *)
  along : int -> int -> Timeline.extent -> Truth.t Timeline.t;
  (** [along p s extent] is predicate [p] along the flow of a known node [s], which has this extent. *)
  steady : int -> bool;
  (** [steady p] is true if [p] is constant along each flow, with its value at the node. Then [along] is not
      called. *)
}

type t

val create :
  ?effort:Scc_chance.Effort.t ->
  ?still:(Timed_formula.t -> Timed_formula.t option) ->
  Timed_graph.index -> predicates -> t
(** [create ~effort ~still index predicates] is an evaluator with a cache of the sets of all sub-formulas. [effort]
    is that for probabilities. [still g] is a predicate that holds at all positions from which a run may come to
    [g]; [None] if no such predicate is known. So "f U g" is "(f and still g) U g", which may be known where the
    former is not: a node at which [still g] fails need not be known. *)

val index : t -> Timed_graph.index
(** [index e] is the graph with its reversed edges, as given to {!create}. *)

val graph : t -> Timed_graph.t
(** [graph e] is the graph. *)

val effort : t -> Scc_chance.Effort.t
(** [effort e] is the effort for probabilities. *)

val predicates : t -> predicates
(** [predicates e] is the predicates given to {!create}. *)

(** The positions at which a formula surely holds, and those at which it perhaps holds. *)
type value = { lower : Positions.t; upper : Positions.t  (** physically the lower set if all is decided *) }

val value : t -> Timed_formula.t -> value
(** [value e f] is the value of [f] at all positions, from the cache or computed now. *)

(** For each part of formulas that are evaluated one after the other, the last formula that needs it. *)
type uses

val uses : t -> Timed_formula.t array -> uses
(** [uses e formulas] is the table for formulas that are evaluated in this order. *)

val done_with : t -> uses -> int -> unit
(** [done_with e uses n] drops from the cache the values that no formula after number [n] needs, and all answers of
    {!probability}. It is called after each formula, in order. Each value takes memory for each state. *)

val truth : t -> Timed_formula.t -> Positions.position -> bool option
(** [truth e f p] is the truth of [f] at position [p]; [None] if it is undecided. *)

val is_chain : t -> bool
(** [is_chain e] is true if no state of the graph leaves a choice ({!Timed_graph.is_chain}). *)

(** A probability: it is at least [least] and at most [most], which are equal if all is known. *)
type measured = { least : Scc_chance.Answer.t; most : Scc_chance.Answer.t }

val probability : t -> decide:bool -> Timed_formula.side -> Timed_formula.t -> Positions.position -> measured
(** [probability e ~decide side f p] is the least or greatest probability that a run from [p] satisfies the top
    operator of [f], whatever its quantifier. The operator is F, G or U (a bug otherwise). With [decide] the
    computation stops once the test of a [Chance] quantifier is decided. *)

val curve :
  t -> Timed_formula.side -> Timed_formula.t -> int -> ((Timeline.moment * measured) list, string) result option
(** [curve e side f s] is {!probability} from node [s], for all ends T of the bound of [f] up to the one that it
    has: the times at which it may change, increasing, each with the value from there on. At a moment that is not
    attained it changes right after it. It is [None] if the bound has no end, and an error with the reason if there
    are too many times. *)

(** {1 The one operator behind F, G and U} *)

type until = {
  quantifier : Timed_formula.quantifier;
  bound : Timed_formula.bound;
  claim : Timed_formula.t;  (** the left side of the formula *)
  left : Timed_formula.t;  (** the claim, and what still has to be so for the right side ({!create}) *)
  right : Timed_formula.t;
}

val as_until : t -> Timed_formula.t -> (until * bool) option
(** [as_until e f] is an F, G or U as a U, and true if [f] is the negation of that; [None] for other formulas. *)

val still : t -> Timed_formula.t -> Timed_formula.t
(** [still e g] is the predicate of {!create} for [g]; true if there is none. *)

val likely_run : t -> until -> Positions.position -> (Run.t * Scc_exact.Rat.t) option
(** [likely_run e u p] is a run from [p] that surely satisfies the until, of a scheduler that attains the
    probability, with the probability of the run ({!Likelihood.run}). It is [None] for other quantifiers. *)
