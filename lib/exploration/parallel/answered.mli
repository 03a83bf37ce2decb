(** The last answers of a worker. The states in them can then be sent to the worker by place instead of by tuple.
    Such a state is the tuple of an answer with the changes of one of its steps.

    Each answer takes the places behind the one before, and the other side counts them as well. There are 2^22
    places in a ring; new answers overwrite the oldest ones. *)

open Scc_graph_search

type t

val create : width:int -> t
(** An empty ring, for tuples of this width. It takes 16 MiB, of which the system provides only what has been
    written. *)

val keep : t -> int array -> Lts.step list -> unit
(** [keep t tuple steps] adds an answer: the tuple of a state, and the steps that were found for it. *)

val tuple : t -> answer:int -> step:int -> int array option
(** [tuple t ~answer ~step] is the state that a step of an answer leads to, by the places of both; [None] if they
    have been overwritten. *)

val words : t -> int
(** The words of memory that the places written so far take. *)

(** {1 Places} *)

val room : width:int -> Lts.step list -> int
(** The number of places of an answer with these steps: the distance to the next answer. *)

val first_step : width:int -> int
(** The distance in places from an answer to its first step. *)

val room_of_step : Lts.step -> int
(** The number of places of a step: the distance to the next step of the answer. *)

val surely : int
(** Half the ring, in places. An answer that is at most this far back will hardly be overwritten before it is
    used. *)
