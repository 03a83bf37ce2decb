(** The evaluation of terms over any view. Numbers and predicates are built from atoms in one way, in a state,
    along a stretch of time, or from the components of a tuple. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property

module type View = sig
  type context  (** what is known before a state or a stretch of time is given *)

  type t  (** an instant, or a stretch of time *)

  (** A number in this view. It may be undefined, for a reason, and it may differ from piece to piece of time. *)
  type number

  (** A truth in this view. It may be undecided, for a reason, and it may differ from piece to piece of time. *)
  type truth

  val semantics : context -> Semantics.t
  (** The semantics of the model. *)

  (** {1 Atoms}

      The value of an atom follows from its meaning. Applied to context and atom alone, both functions may do
      work in advance. *)

  val quantity : context -> Meaning.quantity -> t -> number
  (** The value of an atom that is a number. *)

  val fact : context -> Meaning.fact -> t -> truth
  (** The value of an atom that is a truth. *)

  (** {1 Numbers} *)

  val constant : Rat.t -> t -> number
  (** The number that has this value everywhere. *)

  val neg : number -> number
  (** The negation. *)

  val add : number -> number -> number
  (** The sum. *)

  val sub : number -> number -> number
  (** The difference, the first less the second. *)

  val mul : number -> number -> number
  (** The product. *)

  val div : reason:string -> number -> number -> number
  (** The quotient; undefined, for the reason, where the divisor is zero. *)

  val choose : truth -> (unit -> number) -> (unit -> number) -> number
  (** [choose p a b] is [a ()] where [p] is true, and [b ()] where [p] is false. *)

  val count : number -> truth -> number
  (** [count n p] is [n] plus 1 where [p] is true, and [n] where [p] is false. *)

  (** {1 Truths} *)

  val bool : bool -> t -> truth
  (** The truth that has this value everywhere. *)

  val compare : Law.comparison -> number -> number -> truth
  (** True where the first number stands in this relation to the second. *)

  val not_ : truth -> truth
  (** The negation. *)

  val and_ : truth -> truth -> truth
  (** The conjunction. *)

  val is_false : truth -> bool
  (** [is_false p] is true if [p] is false everywhere. Then the rest of a conjunction need not be evaluated. *)
end

module Make (V : View) : sig
  val num : V.context -> Property.num -> V.t -> V.number
  (** [num c n v] is the value of [n] in [v]. Applied to [c] and [n] alone, it does all work that does not depend
      on [v]. *)

  val prop : V.context -> Property.prop -> V.t -> V.truth
  (** [prop c p v] is the value of [p] in [v]. Applied to [c] and [p] alone, it does all work that does not
      depend on [v]. *)
end
