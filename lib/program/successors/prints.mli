(** A set of fingerprints, numbered from 0 in the order of their insertion. Each takes some 25 bytes, outside
    the OCaml heap. *)

(** A set of at most 2^31 - 1 fingerprints. *)
type t

val create : unit -> t
(** The empty set. *)

val size : t -> int
(** The number of fingerprints. *)

val intern : t -> Keys.fingerprint -> int
(** The number of a fingerprint, which is inserted if it is new. It is new iff its number is the {!size}
    before. *)

val cut : t -> int -> unit
(** Removes the fingerprints from this number on. The time is that of inserting the others again. *)

val bytes : t -> int
(** The memory that the set takes, in bytes. *)
