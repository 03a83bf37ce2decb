(** Pictures of small graphs, for Graphviz. *)

open Scc_property

val predicates : Property.check list -> State_predicates.t array
(** The predicates that determine colours: for each check about states by themselves, its predicate under the
    name of the check. They are meant for {!Labelling.make} with [instants]. *)

val quoted : string list -> string
(** A label: lines between quotes. *)

val write : Exported.t -> Labelling.t -> positions:bool -> (string -> unit) -> unit
(** Writes the graph. Nodes show what distinguishes states ({!State_digest}). A state is red if a predicate that
    some check requires always does not hold there, and green if one that some check requires to be reached
    holds. An edge of time has the colour if this is so on the way.

    A chain of passings of time without choice, along which nothing of this changes, is one edge. An arrow from
    nowhere leads to the initial state. A double border is a state after which nothing ever happens. A dashed
    border is a state whose transitions are not known. A legend explains the marks that occur. *)
