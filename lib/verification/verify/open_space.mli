(** Whether bodies of a state have left all others behind. *)

open Scc_calculus
open Scc_semantics

val is_outside : Semantics.t -> State.t -> inside:(int -> bool) -> others:(int -> bool) -> bool
(** [is_outside c s ~inside ~others] is true if all parts of the leaves for which [inside] is true are outside of
    the least box around the parts of those for which [others] is. Bodies in a room are not outside of it. The box
    has the axes of the world. It is true if there are no others. *)
