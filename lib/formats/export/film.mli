(** A run that is to be told to another program. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_session

(** With all of its states, or by what changes. *)
type run = States of Course.t | Changes of Ways.t

type t = {
  title : string;  (** the name of the model's file *)
  origin : Origin.t;
  run : run;
}

type file = string * ((string -> unit) -> unit)
(** A path, and what writes to it. *)

val model : t -> Model.t
val initial : t -> State.t
val duration : t -> Rat.t

val at : t -> Rat.t -> State.t
(** As {!Course.at}; by what changes, as {!Ways.at}. *)

val tracks : t -> Track.t array
(** Of each leaf of the model. *)

val events : t -> (Rat.t * Transition.label) list
(** All but the passings of time, in order, with when they are. *)

val most_instants : int
(** Of a file: 1 000 000. *)

val too_many : t -> every:Rat.t -> bool
(** More multiples than that lie within the run. *)

val instants : t -> every:Rat.t option -> Rat.t list
(** The times of the states to be told: the start, each instant at which something happens, or each multiple of
    [every], and the end. Each once. *)

val about : t -> (string * Scc_exchange.Json.t) list
(** Which model it is, and with which values of its parameters. *)
