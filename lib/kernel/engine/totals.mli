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
val added : Model.t -> Scc_semantics.Transition.t -> t Lazy.t option
(** What rule Round added in a transition, if it was used. *)

val add : t -> t -> t
val sub : t -> t -> t

val map : (Rat.t -> Rat.t) -> t -> t

(** {1 Long sums}

    The exact sum of many such changes is a number of millions of digits. *)

type sum
(** A sum that is known to within 2^-128 for each of its terms. *)

val no_sum : sum
val accumulate : sum -> t -> sum

val bounds : sum -> t * t
(** Each quantity of the sum lies between those of the two. *)
