(** Behaviours (Definition 5.1): their terms. The rules of [Scc_semantics.Behaviours] define what they may do, and
    how they age. *)

open Scc_exact
open Scc_polyhedra

(** A channel's name and active surface. Two channels are equal if their names and active surfaces are equal
    (reading I-17), however the features were listed. *)
type channel = private {
  name : string;
  sites : Site.t list;  (** the features of Phi that are listed with their closure, sorted *)
  only : Site.t list;  (** the features that are listed without it (reading I-34) and are in no closure; sorted *)
  surface : Site.t list;  (** the active surface: closure([sites]) and [only], sorted; not empty *)
}

val channel : ?only:Site.t list -> name:string -> sites:Site.t list -> closure:Site.t list -> unit -> channel
(** [channel ~only ~name ~sites ~closure ()] is a channel in canonical form: lists sorted, repetitions dropped.
    [closure] must be the closure of [sites]; the caller knows the shapes. [only] is empty by default. A channel
    without features is a bug. *)

val active : channel -> Site.t -> bool
(** [active c site] is true if [site] is in the active surface of [c]. *)

(** alpha ranges over names a and co-names ~a. *)
type polarity = Name | Co_name

(** How a weak split releases a bond: by omega(a, Phi) push(j) chance q. B, or ... rate r. B *)
type loosening = {
  push : Rat.t;  (** j >= 0, and 0 without a push (reading I-36) *)
  odds : Odds.t option;  (** how likely the release is at each split instant (rule Lot); [None]: a free choice *)
}

type t = private
  | Nil
  | Open of polarity * channel * t  (** <alpha, Phi>. B *)
  | Weak of channel * loosening * t  (** omega(a, Phi). B *)
  | Strong of channel list * Rat.t * t
  (** rho(L) push(j). B; L sorted, a set by name and surface, not empty *)
  | Delay of Rat.t * t  (** eps(t). B with t > 0: eps(0).B is B *)
  | Wait of Linear.t * t
  (** eps(t). B where t is an affine form over the parameters that have ranges ({!Ranges}): not constant, and
      nowhere negative. It occurs in models with ranges only. *)
  | Sum of t * t
  | Call of int  (** K, an index into the definitions *)

val nil : t
(** The behaviour that offers nothing and never changes. *)

val open_ : polarity -> channel -> t -> t
(** [open_ alpha c b] is <alpha, Phi>. B. *)

val weak : ?push:Rat.t -> ?odds:Odds.t -> channel -> t -> t
(** [weak ~push ~odds c b] is omega(a, Phi). B. By default the push is 0 and the choice is free. *)

val strong : ?push:Rat.t -> channel list -> t -> t
(** [strong ~push channels b] is rho(L). B, with L sorted and without repetition. By default the push is 0. An
    empty list is a bug. *)

val delay : Rat.t -> t -> t
(** [delay t b] is eps(t). B in canonical form, which is [b] for t = 0 (rule Eps0). A negative t is a bug. *)

val wait : Linear.t -> t -> t
(** [wait t b] is eps(t). B for a form [t] that is nowhere negative. If [t] is constant, it is {!delay}. *)

val written : Linear.t -> t -> t
(** [written t b] is eps(t). B as a model's text has it: an eps(0) stays in the term. {!canonical} takes such
    terms. A negative constant is a bug. *)

val parts : t -> t list
(** [parts b] is the behaviours directly within [b]: what follows a prefix, or both sides of a sum. *)

val sum : t -> t -> t
(** [sum a b] is A + B, without brackets: in the result [Sum (a, b)], the right side [b] is no sum. *)

val call : int -> t
(** [call k] is the name K with index [k] into the definitions. *)

(** A definition K := B. *)
type definition = { name : string; body : t }

type definitions = definition array

val canonical : definitions -> t -> t
(** [canonical written b] is [b] in canonical form, where [written] and [b] may have an eps(0). By rule Eps0,
    eps(0). B is B. By reading I-14, a name K that unfolds, outside of any sum, to eps(0) and a name Z is replaced
    by Z. The definitions must have no unguarded recursion. *)

val canonical_definitions : definitions -> definitions
(** The definitions with each body in its {!canonical} form. *)

(** A behaviour in a state, with where it comes from: [origin] is the K whose ageing gave [term], if any (reading
    I-14). If [term] is a name that was a summand, [origin] may be another name. *)
type aged = private { origin : int option; term : t }

val aged : int option -> t -> aged
(** [aged origin term] is [term] with this origin. *)

val reached : before:int option -> t -> aged
(** [reached ~before term] is a whole behaviour that has just become [term]. Its origin is [term] if that is a
    name, else [before] (reading I-14). *)

val fresh : t -> aged
(** [fresh term] is a behaviour that is initial, or that a discrete transition has just reached. Its origin is
    [term] if that is a name; else it has none. *)

(** {1 What a behaviour may come to} *)

val some_prefix : definitions -> behind:(t -> bool) -> (t -> bool) -> t -> bool
(** [some_prefix defs ~behind is b] is true if [is] holds for a prefix that the search reaches. A prefix is an
    [Open], [Weak], [Strong], [Delay] or [Wait]. The search reaches the prefixes that [b] exposes, and goes on
    after each prefix for which [behind] holds. It looks at each definition once. *)

val channels : t -> channel list
(** The channels of a prefix; none for other terms. *)

val is_delay : t -> bool
(** [is_delay b] is true if [b] is a [Delay] or a [Wait]. As the [behind] of {!some_prefix}, it reaches what is
    offered now or after time has passed. *)

(** {1 Guardedness} *)

val unguarded : may_be_zero:(Linear.t -> bool) -> definitions -> int list
(** [unguarded ~may_be_zero defs] is the indices of the definitions with unguarded recursion, in order. From the
    body of such a definition, its own name is reachable without a prefix or an eps(t), t > 0. For a t over
    parameters, [may_be_zero t] decides if t may be 0. *)

(** {1 Canonical terms} *)

val equal : t -> t -> bool
(** [equal a b] is true if [a] and [b] are the same term, with equal channels where both have channels (reading
    I-17). *)

val compare : t -> t -> int
(** A total order on terms that agrees with {!equal}. *)

val hash : t -> int
(** A hash that agrees with {!equal}. It reads the upper 4 levels of a term, and how long its branches are below.
*)

val equal_aged : aged -> aged -> bool
(** [equal_aged a b] is true if [a] and [b] have equal origins and equal terms. *)

val compare_aged : aged -> aged -> int
(** A total order on behaviours in states: by origin, then by term. *)

val hash_aged : aged -> int
(** A hash that agrees with {!equal_aged}. *)
