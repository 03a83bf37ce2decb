(** A run as it is exported to other programs. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_loading

(** All states of the run, or its changes only. *)
type run = States of Course.t | Changes of Ways.t

(** A run with the model that it belongs to. *)
type t = {
  title : string;  (** the name of the model's file *)
  origin : Origin.t;
  run : run;
}

type file = string * ((string -> unit) -> unit)
(** A path, and the function that writes the file piece by piece. *)

val model : t -> Model.t
(** The model of the run. *)

val initial : t -> State.t
(** The initial state. *)

val duration : t -> Rat.t
(** The model time that the run takes. *)

val at : t -> Rat.t -> State.t
(** The state at a model time, by {!Scc_motion.Course.at} or {!Ways.at}. *)

val tracks : t -> Track.t array
(** The track of each leaf of the model. *)

val events : t -> (Rat.t * Transition.label) list
(** All transitions except the passings of time, in order, each with its model time. *)

val most_instants : int
(** The greatest number of instants in a file: 1 000 000. *)

val too_many : t -> every:Rat.t -> bool
(** [too_many f ~every] is true if more than {!most_instants} multiples of [every] lie within the run. *)

val instants : t -> every:Rat.t option -> Rat.t list
(** The times of the states in a file, each once: the start, the end, and either each multiple of [every] or,
    without [every], each instant of a transition. *)

val about : t -> (string * Scc_json.Json.t) list
(** The name and digest of the model and the values of its parameters, as members of a JSON object. *)
