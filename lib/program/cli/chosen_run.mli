(** The options that choose one run of a model, and how the run is made. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_motion
open Scc_loading
open Scc_verdicts
open Scc_runs
open Cmdliner

type options
(** [--schedule], [--choose], [--start], [--steps], [--time]. *)

val options : sampled:string -> options Term.t
(** The options [--schedule], [--choose], [--start], [--steps] and [--time]. [sampled] is the sentence of the
    manual on where the values of [--start] are reported. *)

(** A chosen run. *)
type t = {
  loaded : Loaded.t;  (** the ordinary model of one start *)
  sampled : (string * Rat.t) list;  (** the values that the start was chosen to have *)
  policy : Replay.policy;
  limits : Replay.limits;  (** a schedule is followed to its end unless a limit is given *)
  is_cut : bool;  (** it ends after {!Scc_runs.Replay.default_steps}, as no limit is given *)
}

val prepare : Console.t -> options -> given:Options.definitions -> string -> (t, Diag.t list) result
(** Reads the schedule, if any, and the model at a path. Warnings of the model are reported. Parameters with
    ranges that are left open are SC0903. *)

val each :
  Loaded.t ->
  Replay.policy ->
  Replay.limits ->
  interrupted:(unit -> bool) ->
  start:(State.t -> unit) ->
  leg:(Course.leg -> unit) ->
  (Rat.t * Replay.ending, Replay.failure) result
(** Makes the run: calls [start] with the initial state, then [leg] with each leg. The result has the time that
    passes after the last one. *)

val follow :
  Loaded.t ->
  Replay.policy ->
  Replay.limits ->
  interrupted:(unit -> bool) ->
  (Course.t * Replay.ending, Replay.failure) result
(** Makes the whole run and keeps all its states. *)

val finish : Console.t -> ?is_cut:bool -> Loaded.t -> (Replay.ending, Replay.failure) result -> Exit_code.t
(** Reports how a run ended, unless it ended regularly. If [is_cut] is true, a note names the options that make a
    run longer in which more can happen. *)
