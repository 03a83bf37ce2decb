(** What is at a place, and what can be written there. *)

open Scc_json

val hover : Session.t -> Json.t -> Json.t
(** What the name or word at a place means, with its exact value; of a check, its verdict. *)

val completion : Session.t -> Json.t -> Json.t
(** What can be written at a place. *)

val signature : Session.t -> Json.t -> Json.t
(** How what is being called at a place is called. *)
