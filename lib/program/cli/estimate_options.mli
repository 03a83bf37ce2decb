(** How probabilities and means are estimated from runs: the options of [scc estimate] and of
    [scc sweep --estimate]. *)

open Scc_base
open Scc_exact
open Scc_property
open Scc_loading
open Scc_estimate

type t = {
  runs : int option;  (** so many, no less and no more *)
  most : int option;
  confidence : Rat.t;
  width : Rat.t option;
  free : Sample.free;
  steps : int option;
  until : Rat.t option;
  seed : int64;
  normal : bool;
}

val paths :
  Loaded.t -> Property.check list -> by_name:bool -> (Path.t list * (string * string) list, Diag.t list) result
(** [paths l checks ~by_name] is what can be estimated, and the names of the other checks with the reasons. If the
    checks were chosen by name, one that cannot be estimated is an error. *)

val aim : t -> Estimation.aim
(** The precision that the options require, with their defaults. *)

val plan : t -> Loaded.t -> Path.t list -> Sample.plan
(** What is sampled of a model. *)

val described : t -> (string * string) list
(** The options with their values, defaults included. *)

val given : t -> string list
(** The options that are not at their defaults, by their names. *)

val count : int Cmdliner.Arg.conv
(** A positive number of runs. *)

val term : t Cmdliner.Term.t
(** The options. Those that exclude each other are a usage error. *)
