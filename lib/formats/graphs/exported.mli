(** Facts on an exported graph that all formats contain. *)

open Scc_verify
open Scc_loading

(** A graph with its model. *)
type t = {
  loaded : Loaded.t;
  space : Explored.t;
}

val summary : t -> string list
(** The model with its parameters, the extent of the exploration, and what is missing and why. One line each,
    for comments. *)

val label_notes : Labelling.t -> string list
(** The labels that are incomplete, and why. One line each, for comments. *)
