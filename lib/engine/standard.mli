(** The semantics as everybody runs it: exact geometry with a memory of contact queries, and neighbours by boxes.
    Neither changes an answer. *)

open Scc_calculus
open Scc_semantics

val of_model : Model.t -> Semantics.t
(** With a new memory: one is made for a model, and kept. *)
