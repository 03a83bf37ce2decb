(** Means over the runs of a timed graph with draws: the least and the greatest of all schedulers (rule
    Expectation).

    A sum until g is infinite for a run that never comes to g, as in PRISM and Storm (Forejt, Kwiatkowska, Norman
    and Parker, "Automated Verification Techniques for Probabilistic Systems", 2011). *)

open Scc_exact

type what =
  | Time_until of Timed_formula.t  (** the time until it holds for the first time *)
  | Counts_until of (int -> int -> int * int) * Timed_formula.t
  (** The number of things that happen until the formula holds. The function has, for a node and the index of one
      of its edges, how many happen by it: at least and at most. *)
  | Value_at of (int -> Rat.t -> (Rat.t, string) result) * Rat.t
  (** The value of a number at this time, after all transitions at that instant. The function has the number at an
      offset of the flow of a node, or at the node (0). *)

val over_before : elapsed:Rat.t -> Rat.t -> string
(** The reason why a number has no value at a time, where a run is over before: after [elapsed]. *)

type answer =
  | Known of Eval.measured
  | Unknown of { reason : string option; unexplored : int list }
  (** No value is known: the number has no value somewhere, or states matter whose successors are not known. *)

val find : ?bound:Scc_chance.Answer.bound -> Eval.t -> Timed_formula.side -> what -> answer
(** [find e side what] is the least or greatest mean over runs from node 0. An interval that decides [bound] is
    good enough, if it is given. *)

(** {1 As a process} *)

(** The process whose mean reward until [Goal] is a mean, but for a number that is added to it. *)
type process = {
  choices : Decisions.place -> Decisions.branch list list;
  built : Decisions.built;  (** from one start *)
  added : Rat.t;
}

val process : Eval.t -> Timed_formula.side -> what -> (process, string) result
(** [process e side what] is the process for a mean if all of it is known exactly; otherwise the reason why not. *)
