(** An exploration that is noted while it goes on, and follows what was noted of it before.

    A note tells of a state that was expanded what that has added to the graph: new states, and edges that changed
    something. States are expanded in an order that is determined by the graph, and so any beginning of the notes
    makes the graph as it was when the last of them was written, by the same steps and with the same visits. What
    comes after the last note is expanded as if there were none. Faults, and states without transitions, are not
    noted but looked at again: they are few, and what they tell the transition system besides is told again. *)

open Scc_graph_search

exception Unfit of string
(** The notes are not of this exploration, in words. *)

module Make
    (L : Lts.S)
    (_ : Lts.Exchange with type context = L.context)
    (Graph : module type of Explore.Make (L)) : sig
  val expanding : ?block:int -> Log.t -> Graph.expanding -> Graph.expanding
  (** By what was kept, and then by another one, which is asked for when it is needed. [block]: {!Blocks.make}. *)
end
