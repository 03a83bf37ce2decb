(** What is likely to keep an exploration over zones from closing. *)

open Scc_calculus
open Scc_verify

val find : Model.t -> Zone_explored.t -> Growth.cause list
(** [find m e] is {!Growth.Grid} if a bound on depth, states, seconds or memory has ended the exploration, and a
    third or more of the deepest zones only wait for the next instant of the grid of weak splits. *)
