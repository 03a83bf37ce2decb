(** What every export says of the graph it is made of. *)

open Scc_verify
open Scc_session

type t = {
  loaded : Loaded.t;
  space : Explored.t;
}

val summary : t -> string list
(** For comments, a line each: the model with its parameters, how much was explored, and what is missing and
    why. *)

val label_notes : Labelling.t -> string list
(** For comments: the labels that do not tell all, and why. *)
