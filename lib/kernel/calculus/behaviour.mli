(** Behaviours (Definition 5.1): their terms. What they may do, and how they age, is told by the rules of
    [Scc_semantics.Behaviours]. *)

open Scc_exact
open Scc_polyhedra

(** A channel's name and active surface. Two are equal when name and surface are (reading I-17), whatever is
    listed. *)
type channel = private {
  name : string;
  sites : Site.t list;  (** those of Phi that are listed with their closure, sorted *)
  only : Site.t list;  (** those that are listed without (reading I-34), and are in no closure; sorted *)
  surface : Site.t list;  (** the active surface: closure([sites]) and [only], sorted; not empty *)
}

val channel : ?only:Site.t list -> name:string -> sites:Site.t list -> closure:Site.t list -> unit -> channel
(** Sorts the lists and drops repetitions; [closure] must be the closure of [sites] (the caller knows the
    shapes). *)

val active : channel -> Site.t -> bool
(** Whether a feature is in the active surface. *)

(** alpha ranges over names a and co-names ~a. *)
type polarity = Name | Co_name

(** How a weak split releases a bond: by omega(a, Phi) push(j) chance q. B, or ... rate r. B *)
type loosening = {
  push : Rat.t;  (** j >= 0, and 0 without a push (reading I-36) *)
  odds : Odds.t option;  (** how likely it is at each split instant (rule Lot); [None]: a free choice *)
}

type t = private
  | Nil
  | Open of polarity * channel * t  (** <alpha, Phi>. B *)
  | Weak of channel * loosening * t  (** omega(a, Phi). B *)
  | Strong of channel list * Rat.t * t
  (** rho(L) push(j). B; L sorted, a set by name and surface, not empty *)
  | Delay of Rat.t * t  (** eps(t). B with t > 0: eps(0).B is B *)
  | Wait of Linear.t * t
  (** eps(t). B where t is not known but for a form over the parameters that have ranges ({!Ranges}): not
      constant, and nowhere negative. In models with ranges only. *)
  | Sum of t * t
  | Call of int  (** K, an index into the definitions *)

val nil : t
val open_ : polarity -> channel -> t -> t
val weak : ?push:Rat.t -> ?odds:Odds.t -> channel -> t -> t
val strong : ?push:Rat.t -> channel list -> t -> t

val delay : Rat.t -> t -> t
(** [delay t b] is [b] when t = 0 (rule Eps0, canonical form); t is not negative. *)

val wait : Linear.t -> t -> t
(** [wait t b], t nowhere negative: {!delay} when t is constant. *)

val written : Linear.t -> t -> t
(** {!wait} as it is written, also with t = 0: for definitions and terms of which {!canonical} is taken. *)

val sum : t -> t -> t
(** Sums have no brackets: [Sum (a, b)] has no sum for its [b]. *)

val call : int -> t

(** A definition K := B. *)
type definition = { name : string; body : t }

type definitions = definition array

val canonical : definitions -> t -> t
(** [canonical written b] is [b] in canonical form, where [written] and [b] may have an eps(0). Rule Eps0: eps(0).
    B is B. Reading I-14: a name K that unfolds, outside of any sum, to eps(0) and a name Z is Z at once, so that Z
    stands for it. The definitions have no unguarded recursion. *)

val canonical_definitions : definitions -> definitions
(** Definitions as they are written, each body in its {!canonical} form. *)

(** A behaviour in a state, with where it comes from: [origin] is the K whose ageing gave [term], if any (reading
    I-14). It may be another one than the name that [term] is, where that was a summand. *)
type aged = private { origin : int option; term : t }

val aged : int option -> t -> aged
(** [aged origin term]: the term of an origin that is known. *)

val reached : before:int option -> t -> aged
(** What a whole behaviour has just become: if that is a name, it is the origin, else [before]. *)

val fresh : t -> aged
(** A behaviour that a discrete transition has just reached (or an initial one). *)

(** {1 What a behaviour may come to} *)

val some_prefix : definitions -> behind:(t -> bool) -> (t -> bool) -> t -> bool
(** [some_prefix defs ~behind is b]: whether some prefix (an [Open], [Weak], [Strong], [Delay] or [Wait]) [is] so,
    of those that b exposes, and of those that come after one that is looked [behind]. *)

val is_delay : t -> bool
(** A [Delay] or a [Wait]: to look behind these alone finds what is offered now or when time has passed. *)

(** {1 Guardedness} *)

val unguarded : may_be_zero:(Linear.t -> bool) -> definitions -> int list
(** The definitions from whose body their own name is reachable without a prefix or an eps(t), t > 0; where t
    depends on what is not known, it is the caller who says whether it may be zero. *)

(** {1 Canonical terms} *)

val equal : t -> t -> bool
val compare : t -> t -> int
val hash : t -> int
val equal_aged : aged -> aged -> bool
val compare_aged : aged -> aged -> int
val hash_aged : aged -> int
