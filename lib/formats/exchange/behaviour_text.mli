(** Behaviours as text, in the syntax of the language. *)

open Scc_calculus

val to_string : Model.t -> leaf:int -> Behaviour.t -> string
(** The term as the leaf's; features are named from the leaf's shape ([right], [left.top]). A sum on the
    right of a sum is bracketed, so that different terms are different texts. *)
