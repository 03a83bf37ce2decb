(** Transitions that are found by several processes at once.

    One process has the graph and all numbers. It uses the transitions in the order in which states are expanded,
    so the graph is the same as that of a single process. Workers receive states ahead of their turn, as these
    are likely to be expanded, and send back their transitions. Answers that are not used in the end are dropped.
    Workers are forked from this process, and then have numbers of their own. Each side sends each thing as bytes
    once ({!Wire}). Processes, rather than threads, work with OCaml 4.13 to 5.3.

    A worker that dies is replaced, and other processes find the transitions that it was to find. *)

open Scc_graph_search

(** When workers are started. *)
type start =
  | At_once
  | When_it_pays
  (** after half a second, while there are at most 2^19 states, and only if finding transitions takes long enough
      ({!Balance.pays}): else several processes would be slower *)

module Make
    (L : Lts.S)
    (_ : Lts.Exchange with type context = L.context)
    (Graph : module type of Explore.Make (L)) : sig
  val expanding : jobs:int -> start:start -> Graph.expanding
  (** [expanding ~jobs ~start] expands states with [jobs] processes. This process is one of them, and finds what
      the workers leave. With 1 job it is {!Graph.here}. *)
end
