(** Who of some processes in translation collides, and when the next two come into contact: pair by pair, each
    looked at once and remembered. *)

open Scc_exact

type t

val create : memory:int -> Local.t -> t
(** [memory], a power of two, bounds how many pairs are remembered. *)

(** What all pairs in relative motion come to. *)
type found

val among : t -> Local.alone array -> found
val collisions : found -> Local.move list
(** The last first. *)

val first_contact : t -> found -> Rat.t option
(** The least time after which two are in contact, if none collide now. *)
