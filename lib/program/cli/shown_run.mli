(** Runs by choices, for a page. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_loading
open Scc_runs
open Scc_view

type simulated = { until : Rat.t; most_steps : int; mutable steps : int }
(** The last time of a simulation, how many steps of a run are shown, and how many there were. *)

val replay :
  Loaded.t ->
  simulated option ->
  Replay.policy ->
  Replay.limits ->
  interrupted:(unit -> bool) ->
  (Replay.event -> unit) ->
  (Replay.ending, Diag.t list) result
(** As {!Replay.run}. A run that is interrupted ends there, and so does one that is given up, unless it is that of
    a schedule: checks may be decided before. *)

val ending : Loaded.t -> Replay.ending -> string list
(** How a run ends, in words. *)

type t = {
  initial : State.t;
  steps : Runs.step list;
  offset : Rat.t;  (** the time that passes after the last step *)
  ending : Replay.ending;
  words : string list;  (** about the end *)
}

val follow :
  Loaded.t ->
  simulated option ->
  Replay.policy ->
  Replay.limits ->
  too_long:(State.t -> bool) ->
  interrupted:(unit -> bool) ->
  (t, Diag.t list) result
(** A run by choices, up to where it ends, or to a state whose numbers are [too_long]. *)
