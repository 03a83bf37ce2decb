(** The switches of the semantics that a model may choose (readings I-31 to I-33, I-35, I-37), for random
    networks. *)

open Scc_calculus

type t

val off : t
(** What holds if a model says nothing. *)

val together : t
val local : t

val by_contact : t
val rings : t

val absorbing : t

val drawing : t

val lots : t

val rounding : t
(** One of them alone; the last rounds velocities to quarters. *)

val pushes : t -> bool
(** Whether splits push apart what they release (reading I-36), which is a matter of the behaviours. *)

val closes_rings : t -> bool
(** Whether bonds may close rings (reading I-37), for which behaviours bind more than once. *)

val without_pushes : t -> t

val absorbs : t -> bool
(** Whether some fixed bodies absorb what hits them (rule Absorb). *)

val draws : t -> bool
(** Whether bodies under a law of motion draw their velocities (rule Draw). *)

val has_lots : t -> bool
(** Whether some weak splits are left to chance (rule Lot), which is a matter of the behaviours. *)

val law : t -> Law.t
(** Of bodies under a law: they fall, or draw among falling and others. *)

val generate : ?rigid:bool -> ?draws:bool -> unit -> t QCheck2.Gen.t
(** Some on, some off: collisions together, steps of single processes or steady ones (where something is
    steered), pushes, rings, bodies that absorb, velocities and splits that are drawn and, but with [rigid],
    binding by contact. With [draws] false nothing is drawn. *)

val apply : t -> Model.t -> Model.t
val print : t -> string
