(** Whether two graphs are equivalent, and if not, why.

    - [Trace]: the same sequences of labels can be observed, silent actions and the passing of time not being seen
      (weak trace equivalence).
    - [Weak], [Branching]: bisimilarity with silent steps, time passing being one; divergence is not looked at.
    - [Strong]: bisimilarity; silent actions are actions like others, and so is the passing of time, [time],
      whatever its duration, once consecutive passings are merged ({!Passing.merge}).
    - [Timed]: bisimilarity over dense time: silent actions are actions like others, time passes by exact durations
      and is additive.

    Graphs not all of whose states are known are never said to be equivalent; that they differ is said only when
    it holds whatever the unknown states can do. *)

type relation = Trace | Weak | Branching | Strong | Timed

(** What one graph can do and the other cannot. *)
type difference = {
  trace : (string list * bool) option;
  (** a shortest trace of the first graph (of the second, when false) that the other does not have; [None] if
      there is none, or {!trace_open} *)
  trace_open : bool;  (** whether there is one could not be found out *)
  formula : Formula.t option;  (** true of the first, false of the second; checked on both; [None] if too large *)
}

type reason =
  | Unknown_states  (** the difference, if there is one, lies beyond what is known *)
  | Effort_spent  (** {!Effort} *)
  | Too_many_sets  (** {!Traces.to_decide} *)
  | Too_many_pairs  (** {!Game.most_pairs}: only when time passes in two ways from one state *)

type verdict = Equivalent | Different of difference | Undecided of reason

type side = {
  states : int;  (** of the graph as it was compared: see {!prepare} *)
  transitions : int;
  classes : int option;  (** of equivalent states, when they were computed *)
}

type report = {
  verdict : verdict;
  first : side;
  second : side;
  show : Formula.t -> string;
}

val prepare : relation -> Graph.t -> Graph.t
(** What is compared: the reachable part, with the passing of time as the relation sees it. *)

val run : Effort.t -> relation -> Graph.t -> Graph.t -> report
(** Compares the initial states of two graphs that {!prepare} has made. *)

val given_up : report
(** Of work that was broken off from outside: as if {!Effort} were spent before anything was compared. *)
