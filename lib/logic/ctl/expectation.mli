(** Means over the runs of a timed graph with draws, of all schedulers the least and the greatest (rule
    Expectation).

    What a run earns until g counts as infinite where it never comes to g, as PRISM and Storm have it (Forejt,
    Kwiatkowska, Norman and Parker, "Automated Verification Techniques for Probabilistic Systems", 2011). *)

open Scc_exact

type what =
  | Time_until of Formula.t  (** the time until it holds for the first time *)
  | Counts_until of (int -> int -> int * int) * Formula.t
  (** what is counted until it holds: of each edge of a node by its index, how often it happens by it, at least and
      at most *)
  | Value_at of (int -> Rat.t -> (Rat.t, string) result) * Rat.t
  (** of a number, at an offset of the flow of a node, or at the node: what it is at this time, after all that
      happens at that instant *)

type answer =
  | Known of Eval.measured
  | Unknown of { reason : string option; unexplored : int list }
  (** nothing is known: the number has no value somewhere, or states matter of which it is not known what follows
  *)

val find : Eval.t -> Formula.side -> what -> answer
(** From node 0 on. *)
