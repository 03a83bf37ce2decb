(** The conserved quantities of mechanics, of a network as a whole. Processes with a fixed leaf are left out. *)

open Scc_exact
open Scc_calculus

type t = {
  momentum : Vec.t;  (** linear momentum, in the world *)
  angular : Vec.t;  (** angular momentum about the origin of the world *)
  energy : Rat.t;  (** kinetic energy *)
}

val added : Model.t -> Scc_semantics.Transition.t -> t Lazy.t option
(** The change of the totals by rule Round in a transition, exactly; [None] if the transition does not use the
    rule. *)

(** {1 Long sums}

    The exact sum of many such changes is a number of millions of digits. *)

type sum
(** A sum that is known to within 2^-128 for each of its terms. *)

val no_sum : sum
(** The sum of no terms, which is 0. *)

val accumulate : sum -> t -> sum
(** [accumulate sum t] is [sum] with one more term. *)

val bounds : sum -> t * t
(** Lower and upper bounds on each quantity of the sum. They differ by 2^-128 times the number of terms. *)
