(** A set of fingerprints, numbered from 0 as they come in: some 25 bytes for each, outside the OCaml heap. *)

type t

val create : unit -> t
val size : t -> int

val intern : t -> Keys.fingerprint -> int
(** Its number. It is new iff this is the {!size} before. *)

val cut : t -> int -> unit
(** Forgets those from this number on. It takes as long as putting the others in again. *)

val bytes : t -> int
(** What it takes. *)
