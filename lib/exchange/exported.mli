(** What every export says of the graph it is made of. *)

open Scc_exact
open Scc_property
open Scc_verify

type t = {
  name : string option;  (** of the model *)
  digest : string;  (** see {!Model_digest} *)
  parameters : (string * Rat.t) list;
  checks : Property.check list;
  space : Explored.t;
}

val summary : t -> string list
(** For comments, a line each: the model with its parameters, how much was explored, and what is missing and
    why. *)

val label_notes : Labelling.t -> string list
(** For comments: the labels that do not tell all, and why. *)
