(** Transitions that are found by several processes at once.

    One process has the graph and all numbers, and takes up what is found in the order in which states are
    expanded: so the graph is that of one process. Others are sent states ahead of their turn, as they are likely
    to be expanded, and send back their transitions; what is not asked for in the end is forgotten. They are
    forked from this process, and from then on have numbers of their own; things are told from each side to the
    other as bytes, once each ({!Wire}). Processes, and not threads, so that it works with OCaml 4.13 to 5.3.

    One that dies is replaced, and what it was to find is found by others. *)

open Scc_graph_search

(** When others are called in. *)
type start =
  | At_once
  | When_it_pays
  (** after a time, and only if what there is to find takes longer than to tell of it: else it would be slower *)

module Make
    (L : Lts.S)
    (_ : Lts.Exchange with type context = L.context)
    (Graph : module type of Explore.Make (L)) : sig
  val expanding : jobs:int -> start:start -> Graph.expanding
  (** With so many processes; this one is among them, and finds what the others leave. With 1 it is
      {!Graph.here}. *)
end
