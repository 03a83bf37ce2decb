(** States as bytes and back. The bytes of a state mean the same to every process that has read the same model, and
    equal states have equal bytes: they are told apart by them, stored and sent. The format, with its version, is
    told in [specs/state-bytes.md]. *)

open Scc_calculus

type t

val version : int
(** The first byte. It changes whenever the bytes of some state do. *)

val make : Model.t -> State.t -> t
(** With the initial state, as {!Scc_semantics.Network.initial} gives it. *)

val encode : t -> State.t -> string
(** Of a state that is reachable in the model. *)

val decode : t -> string -> (State.t, string) result
(** [decode t (encode t s)] is [Ok s], and nothing but [encode t s] gives [s]. Otherwise what is wrong. What is
    decoded names leaves, features and behaviours that are there; whether it is well-formed, is for
    {!Scc_semantics.Well_formed} to say. *)

(** {1 Parts}

    The bytes of parts of a state, as they stand in it, for those who tell states apart by their parts. [version]
    is not among them. Readers raise {!Packed.Malformed}; they do not ask whether what they read is in the one
    form that it has, so that they are for bytes that were written by the same program. *)

val put_process : t -> Buffer.t -> State.process -> unit
val process : t -> Packed.source -> State.process
val put_step : Buffer.t -> State.step -> unit
val step : Packed.source -> State.step
val put_bond : t -> Buffer.t -> State.bond -> unit
val bond : t -> Packed.source -> State.bond

(** {1 Piece by piece}

    The bytes of a state are its head, those of its processes one after the other, and the rest: for whoever knows
    the bytes of processes already. Readers raise {!Packed.Malformed}. *)

val put_head : Buffer.t -> int -> unit
(** The version, and how many processes there are. *)

val put_rest : Buffer.t -> step:State.step option -> time:Scc_exact.Rat.t option -> unit
val read_head : Packed.source -> int

val read_process : t -> string -> from:int -> State.process * int
(** The process that begins at a place, in its own form, and where it ends. No two begin alike: where the bytes of
    one are, there is that one. *)

val read_rest : Packed.source -> State.step option * Scc_exact.Rat.t option
