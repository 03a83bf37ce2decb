(** What every export of a graph of zones says of it. *)

open Scc_verify
open Scc_session

type t = { loaded : Loaded.t; space : Zone_space.t }

val summary : t -> string list
(** A line each: the model with its parameters and their ranges, the settings, how much was explored, and what is
    missing and why. *)

val bounds : t -> string list
(** The bounds that left something out, in words. *)
