(** States as values of integer variables, for tools that know of no others: what changes in a graph, but for
    where things are and how they move.

    The first variable is the number of the state, so that no two states are alike and their order is that of
    their values. Then come, for each leaf for which they differ between states, [process_LEAF], the number of
    the first leaf of its process, and [behaviour_LEAF]; and [bonds_NAME], how many bonds of a name there are. *)

open Scc_verify

type t

val make : Explored.t -> t

val names : t -> string list

val values : t -> int -> int list
(** Of a state. *)

val meanings : t -> (string * string list) list
(** For each variable in the order of [names]: what its values from 0 on stand for; none for counts and for
    the number of the state. *)
