(** Behaviours as text, in the syntax of the language. *)

open Scc_calculus

val to_string : Model.t -> leaf:int -> Behaviour.t -> string
(** The term as that of the leaf. Features have their names on the leaf's shape ([right], [left.top]). A sum on
    the right of a sum is in parentheses, so that different terms are different texts. *)
