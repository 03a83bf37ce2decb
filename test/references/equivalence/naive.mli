(** Equivalences by their definitions, on small graphs: greatest fixpoints over all pairs of states, and traces by
    enumeration. Nothing here is shared with the library but the type of graphs. *)

open Scc_equivalence

val make : ?unknown:int list -> int -> (int * string * int) list -> Graph.t
(** [make size edges]: the initial state is 0. *)

val edges : Graph.t -> (int * string * int) list

type relation = Strong | Branching | Weak

val bisimilar : relation -> Graph.t -> bool array array
(** All pairs of states of one graph. *)

val related : relation -> Graph.t -> Graph.t -> bool
(** The initial states of two. *)

val traces : int -> Graph.t -> string list list
(** The observable traces of at most so many actions, sorted. *)

val time_steps : unit_:int -> Graph.t -> Graph.t
(** Each [time(n/unit)] in n steps [tick], and [time(forever)] as a step to where there are only steps: timed
    bisimilarity is then strong bisimilarity, when every duration is a multiple of 1/unit. *)
