(** From the states of all owners to one graph at the first owner ({!Gathered}). Each owner computes the
    transitions of its states once more, and sends the first owner what formulas need to know of them. A
    transition to a state of another owner is sent there, and its owner tells the first one. The graph has no
    geometry; what depends on it later, values of numbers, the first owner asks for one by one. *)

open Scc_exact

type t

val make : Part.t -> Mesh.t -> Records.t array -> Wanted.t -> t
(** One owner, that may hear of others before it begins itself. *)

val heard : t -> int -> char -> string -> bool
(** [heard g peer kind text] notes a message of the owner [peer]. It is false if the kind is of something else. *)

val gather : t -> Node_numbers.t -> is_expanded:(int -> bool) -> Gathered.t option
(** The graph, at the first owner. All owners gather at the same time, with all states at their owners. They may do
    so again when they have explored more. *)

val value : t -> Gathered.t -> Scc_property.Property.num -> int -> Rat.t -> (Rat.t, string) result
(** [value g graph n node offset] is the value of a number at an offset of the trajectory from a node, or why it
    has none. It is called at the first owner, while the others wait for messages. *)
