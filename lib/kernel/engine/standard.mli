(** The semantics that all commands use. It has exact geometry, with caches of contact queries and of casts. It
    has caches of constant laws, and of the answers about processes and pairs. Its neighbours are found by boxes.
    No answer depends on these caches and filters. *)

open Scc_calculus
open Scc_semantics

val of_model : Model.t -> Semantics.t
(** [of_model m] is this semantics for [m], with empty caches. Make it once for a model, and keep it. *)
