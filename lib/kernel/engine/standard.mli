(** The semantics as everybody runs it: exact geometry with memories of contact queries and of casts, a memory of
    laws that never change, one of what processes do alone and in twos, and neighbours by boxes.
    None of them changes an answer. *)

open Scc_calculus
open Scc_semantics

val of_model : Model.t -> Semantics.t
(** With a new memory: one is made for a model, and kept. *)
