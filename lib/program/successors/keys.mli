(** The states of an exploration as bytes, and as fingerprints: what stands for the tuple of numbers of one process
    in all others. The form of both is told in [specs/successors.md].

    The bytes of a process of the network are made and read once, and known again by what they are. *)

open Scc_calculus
open Scc_state_space

type t

val make : Network_lts.context -> State.t -> t
(** With the state that numbers are given by ({!Scc_codec.State_codec.make}): the initial one of the whole
    network. *)

val put : t -> Buffer.t -> int array -> unit
(** The bytes of a state. *)

val bytes : t -> int array -> string

val read : t -> string -> from:int -> stop:int -> (int array, string) result
(** The state that has these bytes, or why none has. *)

(** {1 Fingerprints}

    128 bits, as four numbers of 32 bits. *)

type fingerprint = int array

val words : int
(** In a fingerprint. *)

val fingerprint : t -> int array -> fingerprint

val after : t -> fingerprint -> int array -> Scc_graph_search.Tuples.changes -> int array -> fingerprint
(** [after t f tuple changes target]: that of the target of a step, given that of the state before. *)

val move :
  t -> into:fingerprint -> fingerprint -> int array -> Scc_graph_search.Tuples.changes -> int array -> unit
(** The same, written into one that is there. *)

val no_fingerprint : unit -> fingerprint
(** To write into. *)

val put_fingerprint : Buffer.t -> fingerprint -> unit
(** In 16 bytes. *)

val hex : fingerprint -> string
