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
(** [offers defs b] is every discrete transition of [b], in the order of the text. Equal summands give one offer,
    except that those left to chance are listed as often as they are written (rule Lot). *)

(** How an offer was derived from the term. *)
type derivation = {
  summand : t;  (** the prefix *)
  within : int option list;
  (** the definitions that it stands in, as far as they are known; [None] for a prefix behind another prefix *)
  by_sum : bool;  (** rule Sum was used on the way to the prefix *)
  by_def : bool;  (** rule Def was used on the way to the prefix *)
}

val derivations : definitions -> aged -> (offer * derivation) list
(** [derivations defs b] is the {!offers} of [b], each with its first derivation. Where equal summands give one
    offer, [within] has the definitions of all of them. *)

val rules : derivation -> Rule.t list
(** The rules of a derivation: that of its prefix (Pre, Weak or Strong), then Sum and Def if they were used. *)

(** {1 Time: rule TimeBehaviour} *)

val horizon : definitions -> aged -> Rat.t option
(** The time until the first exposed eps expires; [None] if no eps is exposed. An exposed
    {!Scc_calculus.Behaviour.Wait}, with a time that is not known, is a bug. *)

val delays : definitions -> aged -> t list
(** The exposed eps, each a [Delay] or a [Wait], in the order of the text. *)

val shorten : definitions -> (t -> t) -> aged -> aged
(** [shorten defs f b] is what [b] becomes within its horizon. [f] takes each exposed eps to what becomes of it: a
    shorter eps, or what follows it if it expires. Origins and repeated summands are as in {!pass}. *)

val pass : definitions -> Rat.t -> aged -> aged
(** [pass defs d b] is the one b' with b --d--> b', for d >= 0; for d = 0 it is [b]. A name without an exposed
    eps stays folded. An aged sum has neither nil nor equal summands, with two exceptions (readings I-14, I-17).
    Summands that offer something by chance, now or later, stay (rule Lot). A single summand that still ages has
    nil beside it. An exposed {!Scc_calculus.Behaviour.Wait} is a bug. *)
