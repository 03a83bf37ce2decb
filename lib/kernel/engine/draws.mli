(** Processes that draw at one instant, one after the other (rule Draw). No draw changes what the other processes
    may draw. So all processes that draw are found when the first one draws, and the next state is made after the
    last draw. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

val waiting : Semantics.t -> State.t -> t option
(** [waiting c s] is the draws of the processes of [s] that wait to draw, none of them made. It is [None] if no
    process waits. *)

val chances : Semantics.t -> t -> ((Given.t * Rat.t) array, Transition.fault) result
(** The motions that the next process may draw, with their probabilities ({!Steer.chances}). *)

val drawer : t -> State.process
(** The process that draws next. It is a bug if all have drawn. *)

val draw : t -> Given.t -> bool
(** [draw d given] makes the next process draw [given]. The result is true if no other process waits. *)

val before : t -> State.process -> Given.t option
(** [before d p] is the motion that [p] has drawn; [None] if it has not drawn. *)

val drawn : t -> State.process list -> State.t
(** [drawn d processes] is {!state} with [processes] alone, which are there apart from draws, in order. *)

val state : t -> State.t
(** The state of {!waiting}, with the draws that have been made. *)
