(** Facts on an exported graph of zones that all formats contain. *)

open Scc_loading
open Scc_zones

(** A graph of zones with its model. *)
type t = { loaded : Loaded.t; space : Zone_space.t }

val summary : t -> string list
(** The model with its parameters and their ranges, the settings, the extent of the exploration, and what is
    missing and why. One line each. *)

val bounds : t -> string list
(** The bounds that left something out, in words. *)
