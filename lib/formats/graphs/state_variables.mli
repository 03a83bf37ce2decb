(** States as values of integer variables, for tools that know no others: all that changes in a graph, except
    positions and velocities.

    The first variable is the number of the state, so no two states have equal values, and their order is that
    of their values. Then follow, for each leaf for which they differ between states, [process_LEAF], the number
    of the first leaf of its process, and [behaviour_LEAF]. Last is [bonds_NAME], the number of bonds of a
    name. *)

open Scc_verify

(** The variables of a graph. *)
type t

val make : Explored.t -> t
(** The variables of an explored graph. It examines every state. *)

val names : t -> string list
(** The names of the variables, in order. *)

val values : t -> int -> int list
(** The values of the variables in a state, in the order of [names]. *)

val meanings : t -> (string * string list) list
(** For each variable in the order of [names], the meanings of its values from 0 on. Counts and the number of
    the state have none. *)
