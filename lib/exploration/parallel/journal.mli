(** An exploration that writes notes, and first follows the notes of an earlier run.

    There is a note for each expanded state. It has what the expansion added to the graph: new states, and edges
    that changed something. The graph determines the order in which states are expanded. So any prefix of the
    notes makes the graph as it was when the last of them was written, by the same steps and with the same
    visits. States after the last note are expanded as without notes. There are no notes for faults and for
    states without transitions, which are few. They are expanded again, with all effects on the transition
    system. *)

open Scc_graph_search

exception Unfit of string
(** The notes are not of this exploration; the text is the reason. *)

module Make
    (L : Lts.S)
    (_ : Lts.Exchange with type context = L.context)
    (Graph : module type of Explore.Make (L)) : sig
  val expanding : ?block:int -> Log.t -> Graph.expanding -> Graph.expanding
  (** [expanding ~block log after] follows the notes of [log], and then expands by [after] and writes notes.
      [after] is started when it is first needed. [block] is the [full] of {!Blocks.make}. Raises {!Unfit}. *)
end
