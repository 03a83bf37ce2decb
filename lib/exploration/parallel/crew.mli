(** Transitions that are found by several processes at once.

    One process numbers the states, in the order in which one process alone would do so. The graph is therefore the
    same. Its tables are in memory that it shares with workers, which are forked from it. All processes find
    transitions and look up their targets, ahead of the turn of the states. Answers that are not used in the end are
    dropped. Processes, rather than threads, work with OCaml 4.13 to 5.3.

    A worker that dies is replaced, and this process finds the transitions that it was to find. *)

open Scc_graph_search

(** When workers are started. *)
type start =
  | At_once
  | When_it_pays
  (** after half a second, while there are at most 2^19 states, and only if finding transitions takes long enough
      ({!Balance.pays}): else several processes would be slower *)

module Make
    (L : Lts.S)
    (Graph : module type of Explore.Make (L)) : sig
  val expanding : jobs:int -> start:start -> Graph.expanding
  (** [expanding ~jobs ~start] expands states with [jobs] processes. This process is one of them. With 1 job it is
      {!Graph.here}, and so it is where the system gives no memory that processes share. *)
end
