(** What the variables of zones are called: by the coordinates that they are. *)

open Scc_calculus
open Scc_symbolic

val coordinate : Model.t -> Zone.t -> int -> string
(** Of {!Zone.coordinates}: ["y"] for a parameter, ["model time"], and of a leaf ["age(p)"], ["clock(p)"],
    ["x(p)"], ["y(p)"], ["z(p)"]. *)

val variable : Model.t -> Zone.t -> int -> string
(** Of a canonical zone; that after the last one is ["time passed"], which guards of passings of time may have. *)
