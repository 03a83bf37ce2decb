(** The names of the variables of zones, by their coordinates. *)

open Scc_calculus
open Scc_state_sets

val coordinate : Model.t -> Zone.t -> int -> string
(** The name of a coordinate in the order of {!Zone.coordinates}. It is ["y"] for a parameter, or
    ["model time"], or one of a leaf: ["age(p)"], ["clock(p)"], ["x(p)"], ["y(p)"], ["z(p)"]. *)

val variable : Model.t -> Zone.t -> int -> string
(** The name of a variable of a canonical zone. The one after the last is ["time passed"], which guards of
    passings of time may have. *)
