(** The states of others that an owner has sent lately, by their fingerprints: they need not be sent again. It is a
    bounded table that may forget. What it forgets is sent again, and the other owner knows it. *)

type t

val create : bytes:int -> t
(** [create ~bytes] is an empty table, of at most about so many bytes. *)

val add : t -> Scc_successors.Keys.fingerprint -> bool
(** [add t print] is true if it is not in the table; then it is added. *)

val near : t -> Scc_successors.Keys.fingerprint -> int
(** Some number near the place of a fingerprint in the table. Who asks for those of several before {!add} has their
    places fetched from memory at the same time. *)
