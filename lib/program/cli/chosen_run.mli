(** Which run of a model is meant: the options that choose one, and the way to follow it. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_motion
open Scc_session
open Scc_exchange
open Cmdliner

type options
(** [--schedule], [--choose], [--start], [--steps], [--time]. *)

val options : sampled:string -> options Term.t
(** [sampled] is the sentence of the manual that says where the values that [--start] takes are told. *)

type t = {
  loaded : Loaded.t;  (** the ordinary model of one start *)
  sampled : (string * Rat.t) list;  (** the values that the start was chosen to have *)
  policy : Replay.policy;
  limits : Replay.limits;  (** a schedule is followed to its end unless a limit is asked for *)
}

val prepare : Console.t -> options -> given:Options.definitions -> string -> (t, Diag.t list) result
(** Reads the schedule, if any, and the model at a path; reports the warnings of the model. SC0903 when parameters
    with ranges are left open. *)

val each :
  Loaded.t ->
  Replay.policy ->
  Replay.limits ->
  interrupted:(unit -> bool) ->
  start:(State.t -> unit) ->
  leg:(Course.leg -> unit) ->
  (Rat.t * Replay.ending, Replay.failure) result
(** Follows the run: its initial state, then each leg; how much time passes after the last one. *)

val follow :
  Loaded.t ->
  Replay.policy ->
  Replay.limits ->
  interrupted:(unit -> bool) ->
  (Course.t * Replay.ending, Replay.failure) result
(** The whole run, kept. *)

val finish : Console.t -> Loaded.t -> (Replay.ending, Replay.failure) result -> Exit_code.t
(** Says how a run ended, unless all is well. *)
