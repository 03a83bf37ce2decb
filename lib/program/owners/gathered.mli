(** The graph of all owners, at the first one: its nodes and what is known of them, without their geometry.
    Formulas are evaluated on it. A node takes some 20 bytes, and each transition 8. *)

open Scc_ctl

type t

val make : size:int -> owners:int -> Wanted.t -> t
(** A graph of so many nodes, of which nothing is known. *)

val nodes : t -> int -> string -> unit
(** [nodes g owner text] adds the nodes of a text that is made of {!Node.put}. Texts of an owner come in order, and
    have its nodes in the order of its own numbers. Raises [Packed.Malformed], as do the other functions. *)

val put_arc : Buffer.t -> source:int -> choice:int -> int -> unit
(** [put_arc b ~source ~choice target] appends a transition, which is the one of this place among those of its
    source. *)

val arcs : t -> string -> unit
(** Adds the transitions of a text. *)

val finish : t -> unit
(** All nodes and transitions are there. Raises [Packed.Malformed] if any is missing. *)

val graph : t -> Timed_graph.t
(** The graph. *)

val predicates : t -> Eval.predicates
(** The predicates of the formulas. *)

val counted : t -> int -> int -> int -> int * int
(** [counted g pattern node edge] is how many events of the pattern happen by an edge of the node. *)

val home : t -> int -> int * int
(** The owner of a node, and the number of the state there. *)
