(** The unchanging part of a network: its shapes, definitions, laws and steps. What changes is in
    {!State}. *)

open Scc_exact
open Scc_geometry

(** A basic shape (Definition 4.4), without the components that change (v, omega and the translation
    of T). *)
type part = {
  name : string;  (** s, unique over the network: ["p"], ["q.left"] *)
  template : string;  (** the name of W *)
  solid : Solid.t;  (** linear(T)(W) *)
  offset : Vec.t;  (** of its reference point from the leaf's *)
  mass : Rat.t;  (** m > 0; of no meaning in a fixed leaf *)
}

(** The shape S of a leaf S[B] (Definition 4.5). *)
type leaf = {
  name : string;  (** ["p"], ["c[3]"] *)
  template : string;  (** of the shape or compound *)
  parts : part array;
  fixed : bool;  (** a wall: infinite mass, never moves *)
  mass : Rat.t;  (** the sum over the parts *)
  law : Law.t;
}

type t = {
  leaves : leaf array;
  definitions : Behaviour.definitions;
  timestep : Rat.t;  (** Delta *)
  split_step : Rat.t;
  keeps_time : bool;  (** absolute time is part of the state: a law or a property needs it *)
  steered : bool;  (** some law is not inertial: the step is part of the state *)
  obstacles : Obstacle_cache.t;
}

val part_count : t -> int

val site_name : t -> leaf:int -> Site.t -> string
(** ["q.left.top"], ["p.[a,b]"]. *)

val leaf_centroid : leaf -> Vec.t
(** Mass centroid of the leaf about its reference point. *)

val obstacle : t -> int * int -> int * int -> Obstacle.t
(** [obstacle m (l1, p1) (l2, p2)]: of part p1 of leaf l1 and part p2 of leaf l2. Made when first asked
    for. *)
