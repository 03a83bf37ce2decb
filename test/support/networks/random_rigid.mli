(** Random networks of the rigid calculus: cubes, planks, tetrahedra and glued parts, off their centres too, some
    bound at birth, some fixed; most fly at each other. *)

open Scc_calculus

(** What a network may have. *)
type features = {
  dynamics : [ `Any | `Constant_spin | `Free_body ];
  rounds : bool;  (** orientations and velocities are rounded, coarsely *)
  laws : bool;  (** some bodies fall *)
  behaves : bool;  (** bodies have channels, delays and splits; else all are nil *)
  plain : bool;  (** each body is one part, the same when reflected in its centre *)
  switched : bool;
  (** random switches of the semantics ({!Switches}), and most of the networks packed: cubes, planks and turned
      cubes in a grid, face to face *)
  draws : bool;  (** what is under a law may draw, where there are switches *)
}

val anything : features
(** But laws of motion, rounding and switches. *)

type t

val generate : features -> t QCheck2.Gen.t
(** Two to four bodies. *)

val model : t -> Model.t
val declared : t -> State.t

val start : t -> Model.t * State.t
(** The model and its initial state. *)

val all_free : t -> t
(** The same with nothing fixed. *)

val print : t -> string

val cube : id:int -> Scc_geometry.Solid.t
(** Of side 2 about its reference point. *)

val plank : id:int -> Scc_geometry.Solid.t
(** Of sides 2, 1 and 1/2. *)

val tetrahedron : id:int -> Scc_geometry.Solid.t
(** With a corner of edges 2, 2 and 3 at its reference point: its centroid is elsewhere. *)

val with_switches : Switches.t -> t -> t

val like : t -> t -> t
(** [like a b]: the second with the dynamics, the rounding and the switches of the first. *)
