(** What a network as a whole has of the quantities that mechanics keeps. Fixed bodies are left out. *)

open Scc_exact
open Scc_calculus

type t = {
  momentum : Vec.t;
  angular : Vec.t;  (** angular momentum about the origin of the world *)
  energy : Rat.t;  (** kinetic *)
}

val zero : t
val of_state : Model.t -> State.t -> t
val add : t -> t -> t
val sub : t -> t -> t
