(** The terms of a model by number: what behaviours can come to is made of these, but for how long delays still
    last. Equal models give equal numbers. *)

open Scc_calculus

type t

val make : Model.t -> State.t -> t
(** Of the definitions and of an initial state: their terms, with all that come after prefixes, and their
    channels. *)

val put : t -> Buffer.t -> Behaviour.t -> unit
val read : t -> Packed.source -> Behaviour.t
(** Raises {!Packed.Malformed}. *)

val put_name : t -> Buffer.t -> string -> unit
(** Of a channel that occurs in the terms or in a bond of the initial state (a bug otherwise). *)

val read_name : t -> Packed.source -> string
