(** What behaviours may do and how they age: the rules of the second chapter of the rule book. *)

open Scc_exact
open Scc_calculus.Behaviour

(** {1 Discrete rules Pre, Weak, Strong, Sum, Def, Eps0} *)

(** A summand that a behaviour offers, with what follows it. *)
type offer =
  | Offer_open of polarity * channel * t
  | Offer_weak of channel * t
  | Offer_strong of channel list * t

val offers : definitions -> aged -> offer list
(** Every discrete transition, in the order of the text, without repetition. *)

(** How an offer was derived from the term: which of the rules Sum and Def were used on the way to its
    prefix. *)
type derivation = { by_sum : bool; by_def : bool }

val derivations : definitions -> aged -> (offer * derivation) list
(** {!offers}, each with its (first) derivation. *)

(** {1 Time: rule TimeBehaviour} *)

val horizon : definitions -> aged -> Rat.t option
(** The time until the first of the exposed eps expires; [None] when none is exposed. *)

val pass : definitions -> Rat.t -> aged -> aged
(** [pass defs d b] is the one b' with b --d--> b', for d >= 0 ([b] itself for d = 0). Names with no exposed
    eps stay folded; an aged sum has neither nil nor equal summands (reading I-17). *)
