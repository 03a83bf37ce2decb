(** The states of an exploration as bytes and as fingerprints. Both mean the same in all processes, unlike the
    tuple of numbers by which one process represents a state. Their formats are in [specs/successors.md].

    The bytes of a process of the network are cached, in both directions. *)

open Scc_calculus
open Scc_state_space

(** The states of one exploration, with caches. *)
type t

val make : Network_lts.context -> State.t -> t
(** The keys of an exploration. The state, by which parts are numbered ({!Scc_codec.State_codec.make}), is the
    initial one of the whole network. *)

val put : t -> Buffer.t -> int array -> unit
(** Appends the bytes of a state. *)

val bytes : t -> int array -> string
(** The bytes of a state. *)

val read : t -> string -> from:int -> stop:int -> (int array, string) result
(** The state with these bytes. The error is the reason why no state has them. *)

(** {1 Fingerprints}

    128 bits, as four numbers of 32 bits. *)

(** Four numbers of 32 bits. *)
type fingerprint = int array

val words : int
(** The number of words of a fingerprint: 4. *)

val fingerprint : t -> int array -> fingerprint
(** The fingerprint of a state: the sum of the digests of its processes and of the rest, word by word. *)

val after : t -> fingerprint -> int array -> Scc_graph_search.Tuples.changes -> int array -> fingerprint
(** [after t f tuple changes target] is the fingerprint of the target of a step. [f] is the fingerprint of the
    state [tuple] before it. *)

val move :
  t -> into:fingerprint -> fingerprint -> int array -> Scc_graph_search.Tuples.changes -> int array -> unit
(** [move t ~into f tuple changes target] writes the fingerprint of {!after} into [into]. *)

val no_fingerprint : unit -> fingerprint
(** A fresh fingerprint, for {!move} to write into. *)

val put_fingerprint : Buffer.t -> fingerprint -> unit
(** Appends a fingerprint in 16 bytes. *)

val hex : fingerprint -> string
(** The 16 bytes of a fingerprint in hexadecimal digits. *)
