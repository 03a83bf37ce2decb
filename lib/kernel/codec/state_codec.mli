(** States as bytes and back. The bytes of a state mean the same in every process that has read the same model.
    Equal states have equal bytes, so bytes identify states, and are stored and sent. The format and its version
    are specified in [specs/state-bytes.md]. *)

open Scc_calculus

type t

val version : int
(** The version of the format, which is the first byte. It changes whenever the bytes of some state do. *)

val make : Model.t -> State.t -> t
(** [make m initial] is the codec for the states of [m] that are reachable from [initial], which
    {!Scc_semantics.Network.initial} gives. *)

val encode : t -> State.t -> string
(** The bytes of a state. A behaviour that no state of the model can have is a bug. *)

val decode : t -> string -> (State.t, string) result
(** [decode t (encode t s)] is [Ok s], and no other bytes give [s]. For bytes that {!encode} does not make, the
    result is an error with its reason. A decoded state names only leaves, features and behaviours of the model.
    For more, check it by {!Scc_semantics.Well_formed}. *)

(** {1 Parts}

    The bytes of parts of a state, as they stand in it, for callers that identify states by their parts.
    [version] is not among them. Readers raise {!Packed.Malformed}. They do not check that their input is in its
    one form, so they are for bytes that the same program has written. *)

val put_process : t -> Buffer.t -> State.process -> unit
(** Appends the bytes of a process. *)

val process : t -> Packed.source -> State.process
(** Reads a process. *)

val put_step : Buffer.t -> State.step -> unit
(** Appends the bytes of the movement step of a network. *)

val step : Packed.source -> State.step
(** Reads the movement step of a network. *)

val put_bond : t -> Buffer.t -> State.bond -> unit
(** Appends the bytes of a bond. *)

val bond : t -> Packed.source -> State.bond
(** Reads a bond. *)

(** {1 Piece by piece}

    The bytes of a state are its head, those of its processes one after the other, and the rest. These functions
    are for callers that have the bytes of processes already. Readers raise {!Packed.Malformed}. *)

val put_head : Buffer.t -> int -> unit
(** [put_head buffer n] appends the head of a state with [n] processes: the version, and [n]. *)

val put_rest : Buffer.t -> step:State.step option -> time:Scc_exact.Rat.t option -> unit
(** Appends what follows the processes of a state: the movement step and the absolute time, if it has them. *)

val read_head : Packed.source -> int
(** Reads the head of a state, and returns the number of its processes. Another version is {!Packed.Malformed}. *)

val read_process : t -> string -> from:int -> State.process * int
(** [read_process t text ~from] is the process whose bytes begin at index [from], and the index behind them. Its
    bytes must be in their one form. The bytes of a process are no prefix of those of another one. *)

val read_rest : Packed.source -> State.step option * Scc_exact.Rat.t option
(** Reads what follows the processes of a state: the movement step and the absolute time, if it has them. *)
