(** What a process has answered lately, so that it can be told of the states that were found in its answers by
    where they came up: such a state is the tuple of an answer with the changes of one of its steps.

    An answer takes a place after the one before, which the other side counts as well; what was kept first is
    overwritten. *)

open Scc_graph_search

type t

val create : width:int -> t
(** Of tuples so wide. *)

val keep : t -> int array -> Lts.step list -> unit
(** The tuple of a state, and the steps that were answered. *)

val tuple : t -> answer:int -> step:int -> int array option
(** The end of a step of an answer, by the places of both; [None] if that has been overwritten. *)

val words : t -> int
(** Of memory that it takes. *)

(** {1 Places} *)

val room : width:int -> Lts.step list -> int
(** How far it is to the next answer. *)

val first_step : width:int -> int
(** From an answer to its first step. *)

val room_of_step : Lts.step -> int
(** From one step to the next. *)

val surely : int
(** What is not farther back than this will hardly be overwritten before it is asked for. *)
