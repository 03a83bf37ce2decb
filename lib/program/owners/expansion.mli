(** What follows the states of an owner: its own states are entered, and those of others are sent to them. *)

open Scc_ctl

(** What is to be told of a state beside its targets. *)
type note =
  | Fault of string  (** its transitions cannot be computed *)
  | End of string  (** it is a dead end, where the model is given up *)
  | Ahead of { goal : int; met : Timeline.moment option; doubtful : Timeline.moment option }
  (** when the goal holds after the state and before the next one, and when it may hold *)

type t

val make : Part.t -> Mesh.t -> Records.t array -> sent:Sent.t -> t
(** [make part mesh records ~sent] is for the states of [part]. [records] has the connection to each owner. *)

val state : char
(** The kind of the messages that {!flush} sends: texts of {!Records}. *)

val next_round : t -> unit
(** A new round of states begins. What leads to a state without duration is sent once in each round. *)

val expand : t -> int -> before:int -> note:(note -> unit) -> int
(** [expand e id ~before ~note] is the number of transitions of the state [id]. [before] stands for it in the
    ways of its targets. What is to be sent is collected. *)

val flush_full : t -> int
(** Sends what has been collected, to those owners for whom it is much. The result is the number of messages. *)

val flush : t -> int
(** Sends all that has been collected, likewise. *)
