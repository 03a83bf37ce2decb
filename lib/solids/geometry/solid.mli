(** A template seen through the linear part of its transformation T (Definition 4.4): integer coordinates
    over one denominator, about the point where T takes the origin of body space. Solids are what the
    contact queries take; bodies that differ by a translation share one. *)

open Scc_exact

type t = private {
  id : int;  (** distinct for distinct solids of one model: the key of caches; or {!derived} *)
  polyhedron : Polyhedron.t;  (** the template, in body space *)
  linear : Mat.t;
  vertices : Ivec.t array;  (** over [denominator] *)
  denominator : Z.t;  (** positive *)
  normals : Ivec.t array;  (** primitive outward normal of each face *)
  topology : Topology.t;  (** that of the polyhedron *)
  directions : Ivec.t array;  (** of each edge, from its tail to its head, primitive *)
  shadow : Shadow.t;  (** the vertices as floats *)
  centroid : Vec.t;  (** of the uniform solid, about the same point *)
  volume : Rat.t;
  inertia : Mat.t;  (** about the centroid, along the axes of the solid, for unit density (rule Mass) *)
  radius : Rat.t;  (** no vertex is farther from the centroid; a short number *)
  box : Float_box.t;  (** about the reference point *)
}

val derived : int
(** -1: the [id] of each solid that is none of a model, as after a turn. It is no key: caches do not keep what is
    made of such solids. *)

val make : id:int -> Polyhedron.t -> Mat.t -> t
(** [make ~id polyhedron m] is the image of the template under the linear map [m]. The determinant of [m] is
    positive (a bug otherwise). *)

val turned : Mat.t -> t -> t
(** [turned rotation s] is [s] after a rotation about its reference point. Its [id] is {!derived}. *)

val vertex : t -> int -> Vec.t
(** [vertex s i] is the rational position of vertex i relative to the reference point. *)

val corners : t -> Feature.t -> int list
(** The vertices of a feature; those of a face in its order. *)

val highest : t -> float array -> float -> int
(** [highest s direction sign] is the vertex that is highest in the direction of the first three numbers times
    [sign], up to rounding. It is any vertex if one of these is a NaN. *)

val uphill : t -> float -> float -> float -> from:int -> int
(** [uphill s x y z ~from] is {!highest} in the direction (x, y, z). The search begins at the vertex [from], or
    at a vertex that is found at once if [from] is negative. *)
