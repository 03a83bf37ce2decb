(** The test of two graphs for equivalence, with a proof of a difference.

    - [Trace] compares the sequences of labels that can be observed, without silent actions and the passing of time
      (weak trace equivalence).
    - [Weak] and [Branching] are bisimilarity with silent steps; the passing of time is silent. Divergence is
      ignored.
    - [Strong] is bisimilarity in which silent actions are actions like others. The passing of time is the action
      [time], whatever its duration, after consecutive passings are merged ({!Passing.merge}).
    - [Timed] is bisimilarity over dense time. Silent actions are actions like others; time passes by exact
      durations and is additive.

    Graphs with states that are not fully known are never found equivalent. They are found different only if that
    holds whatever the unknown states can do. *)

type relation = Trace | Weak | Branching | Strong | Timed

(** A behaviour of one graph that the other one lacks. *)
type difference = {
  trace : (string list * bool) option;
  (** A shortest trace that one graph has and the other lacks; with [true] the first graph has it, with [false] the
      second. [None] if there is none, or if none was found ([trace_open]). *)
  trace_open : bool;  (** the search for a trace was given up *)
  formula : Modal_formula.t option;
  (** A formula that holds for the first graph and not for the second, checked on both; [None] if it is too large.
  *)
}

type reason =
  | Unknown_states  (** any difference depends on states that are not fully known *)
  | Effort_spent  (** the comparison was stopped ({!Effort}) *)
  | Too_many_sets  (** the limits {!Traces.to_decide} were reached *)
  | Too_many_pairs  (** {!Game.most_pairs} was reached: only if time passes in two ways from one state *)

type verdict = Equivalent | Different of difference | Undecided of reason

type side = {
  states : int;  (** the states of the graph as it was compared: see {!prepare} *)
  transitions : int;  (** the transitions of that graph *)
  classes : int option;  (** the number of classes of bisimilar states, if they were computed *)
}

type report = {
  verdict : verdict;
  first : side;
  second : side;
  show : Modal_formula.t -> string;  (** the text of a formula with the labels of the graphs *)
}

val prepare : relation -> Graph.t -> Graph.t
(** [prepare relation g] is the graph that is compared: the reachable part of [g], with the passing of time as the
    relation sees it. *)

val run : Effort.t -> relation -> Graph.t -> Graph.t -> report
(** [run effort relation g h] compares the initial states of two graphs from {!prepare}. If [effort] stops it, the
    verdict is [Undecided Effort_spent], or a difference that may lack a formula or a trace. *)

val given_up : report
(** The report of a comparison that was interrupted from outside: undecided, as if the {!Effort} were spent at the
    beginning. *)
