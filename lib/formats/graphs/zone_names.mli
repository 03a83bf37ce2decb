(** The names of the variables of zones, by their coordinates. *)

open Scc_calculus
open Scc_state_sets

val variable : Model.t -> Zone.t -> int -> string
(** The name of a variable of a canonical zone. The one after the last is ["time passed"], which guards of
    passings of time may have. *)
