(** Random well-formed networks of bodies with the faces of a cube: cubes, boxes, turned cubes, sheared ones,
    glued pairs; some fixed, some with channels, delays, splits. *)

open Scc_calculus

type t

val generate : ?steered:bool -> unit -> t QCheck2.Gen.t
(** Two to six bodies, close together and in motion; shrinks. With [steered] (not by default), some fall
    by a law of motion. *)

val switched : ?steered:bool -> ?draws:bool -> unit -> t QCheck2.Gen.t
(** The same with random switches of the semantics ({!Switches}), most of them packed: face to face in a grid, so
    that much collides at once. With [draws] false nothing is drawn. *)

val absorbing : unit -> t QCheck2.Gen.t
(** Every third body absorbs what hits it, and perhaps others. *)

val linked : t QCheck2.Gen.t
(** Packed, and all that can binds with all its neighbours, where bonds close rings (reading I-37). *)

val rounding : unit -> t QCheck2.Gen.t
(** Of those, with velocities rounded and all else as if nothing were said. *)

val without_pushes : t -> t
val with_switches : Switches.t -> t -> t

val like : t -> t -> t
(** [like a b]: the second with the switches of the first. *)

val crowd : t QCheck2.Gen.t
(** Up to thirty bodies, as close together. *)

val model : t -> Model.t
val declared : t -> State.t

val start : t -> Model.t * State.t
(** The model and its initial state. *)

val with_bystanders : t -> t
(** Sixteen motionless cubes more, a million away: too far to matter for long, but so many that neighbours are
    looked for in another way. *)

val none : t
(** Nobody: a model to put other bodies into. *)

val inert : t -> t
(** The same without channels: nothing binds. *)

val sticking : t -> t
(** The same with channels that fit, and weak splits. *)

val all_free : t -> t
(** The same with nothing fixed: what was, stands still. *)

val print : t -> string
