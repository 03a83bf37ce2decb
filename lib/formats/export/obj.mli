(** A state as Wavefront OBJ: an object for each part, its corners in world coordinates, with their colours, and
    its faces with their names as groups. *)

open Scc_exact
open Scc_calculus

val state : Film.t -> time:Rat.t -> (string -> unit) -> unit
(** The state at a time of the run. *)

val form : Model.t -> leaf:int -> (string -> unit) -> unit
(** A leaf about its reference point, before it turns. *)
