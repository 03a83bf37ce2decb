(** What behaviours may do and how they age: the rules of the second chapter of the rule book. *)

open Scc_exact
open Scc_calculus.Behaviour

(** {1 Discrete rules Pre, Weak, Strong, Sum, Def, Eps0} *)

(** A summand that a behaviour offers, with what follows it. *)
type offer =
  | Offer_open of polarity * channel * t
  | Offer_weak of channel * loosening * t
  | Offer_strong of channel list * Rat.t * t

val offers : definitions -> aged -> offer list
(** Every discrete transition, in the order of the text, without repetition but for what is left to chance (rule
    Lot). *)

(** How an offer was derived from the term. *)
type derivation = {
  summand : t;  (** the prefix *)
  within : int option list;
  (** the definitions that it stands in, as far as they are known: what follows a prefix has none ([None]) *)
  by_sum : bool;  (** rule Sum was used on the way to the prefix *)
  by_def : bool;  (** so was rule Def *)
}

val derivations : definitions -> aged -> (offer * derivation) list
(** {!offers}, each with its first derivation. *)

val rules : derivation -> Rule.t list
(** The prefix's rule, with Sum and Def where they were used. *)

(** {1 Time: rule TimeBehaviour} *)

val horizon : definitions -> aged -> Rat.t option
(** The time until the first of the exposed eps expires; [None] when none is exposed. All are known: no
    {!Scc_calculus.Behaviour.Wait} (a bug otherwise), as in {!pass}. *)

val delays : definitions -> aged -> t list
(** The exposed eps, each a [Delay] or a [Wait], in the order of the text. *)

val shorten : definitions -> (t -> t) -> aged -> aged
(** What a behaviour has come to, up to its horizon: the function says what becomes of each exposed eps, a
    shorter one or, if it expires, what follows it. *)

val pass : definitions -> Rat.t -> aged -> aged
(** [pass defs d b] is the one b' with b --d--> b', for d >= 0 ([b] itself for d = 0). Names with no exposed eps
    stay folded; an aged sum has neither nil nor equal summands, except those that offer something by chance, now
    or later, and that a single one which still ages has nil beside it (readings I-14, I-17, rule Lot). *)
