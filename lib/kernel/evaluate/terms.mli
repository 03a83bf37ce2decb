(** Terms over what one looks at. Numbers and predicates are built from atoms in one way, whether they are looked
    at in a state, along a stretch of time, or by the components of a tuple. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property

module type View = sig
  type context  (** what is known before anything is looked at *)

  type t  (** an instant, or a stretch of time *)

  (** What a number and a truth are there: perhaps undefined or undecided, for a reason; perhaps from piece to
      piece. *)
  type number

  type truth

  val semantics : context -> Semantics.t

  (** {1 Atoms}

      By their meaning. Given the context alone, they may prepare. *)

  val quantity : context -> Meaning.quantity -> t -> number
  val fact : context -> Meaning.fact -> t -> truth

  (** {1 Numbers} *)

  val constant : Rat.t -> t -> number
  val neg : number -> number
  val add : number -> number -> number
  val sub : number -> number -> number
  val mul : number -> number -> number

  val div : reason:string -> number -> number -> number
  (** Undefined, for the reason, where the divisor is zero. *)

  val choose : truth -> (unit -> number) -> (unit -> number) -> number
  val count : number -> truth -> number
  (** One more where it is true. *)

  (** {1 Truths} *)

  val bool : bool -> t -> truth
  val compare : Law.comparison -> number -> number -> truth
  val not_ : truth -> truth
  val and_ : truth -> truth -> truth

  val is_false : truth -> bool
  (** Everywhere: then nothing changes it any more in a conjunction. *)
end

module Make (V : View) : sig
  val num : V.context -> Property.num -> V.t -> V.number
  val prop : V.context -> Property.prop -> V.t -> V.truth
  (** What can be prepared is prepared when the term is given. *)
end
