(** Pictures of small graphs, for Graphviz. *)

open Scc_property

val predicates : Property.check list -> State_predicates.t array
(** What the colours are about: for each check that asks of states by themselves, its predicate, under its
    name. To be given to {!Labelling.make}, with [instants]. *)

val quoted : string list -> string
(** A label: lines between quotes. *)

val write : Exported.t -> Labelling.t -> positions:bool -> (string -> unit) -> unit
(** Nodes tell what matters in a state ({!State_digest}). Red: a predicate that some check wants always does
    not hold; green: one that some check wants to be reached holds. An edge of time has the colour when that
    is so on the way. A chain of passings of time without choice, along which nothing of this changes, is one
    edge. An arrow from nowhere leads to the initial state; a double border is a state in which nothing will
    ever happen again; a dashed one is a state whose transitions are not known. A legend tells what occurs. *)
