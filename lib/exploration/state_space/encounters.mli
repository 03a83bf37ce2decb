(** The collisions and the next contact among some processes in translation. Each pair is computed once, and
    cached. *)

open Scc_exact

type t

val create : memory:int -> Local.t -> t
(** An empty cache. [memory], a power of two, bounds the number of pairs in it. *)

(** What is known of all pairs in relative motion. *)
type found

val among : t -> Local.alone array -> found
(** The pairs in relative motion among some processes. *)

val collisions : found -> Local.move list
(** The outcomes of all collisions now, the last first. *)

val first_contact : t -> found -> Rat.t option
(** The least time after which two of the processes are in contact; [None] if there is none. No two may collide
    now. *)
