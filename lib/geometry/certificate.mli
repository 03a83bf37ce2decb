(** Proofs of what {!Portal} guesses, by signs of integers, which floats decide where a proved bound lets
    them. *)

open Scc_exact

type t
(** A query with its portal. *)

val make : Portal.t -> Vec.t -> Vec.t -> t
(** [make s r w], with the offset and velocity that [s] was made with. *)

type plane
(** A plane that is proved to support the obstacle, wherever B stands. *)

val normal : plane -> Ivec.t
(** Outward. *)

val height : t -> plane -> int
(** The sign of n.p for the points p of the plane: positive when the origin is strictly on the inner side. This
    and what uses it move the last support. *)

val speed : t -> plane -> int
(** The sign of n.w. *)

val never : t -> plane -> bool
(** Whether the plane keeps the interiors apart, now and for all times to come. *)

val apart : t -> plane -> bool
(** Whether the plane keeps the closed bodies apart now. *)

val apart_forever : t -> plane -> bool
(** Whether the plane keeps the closed bodies apart, now and at all times, past and to come. *)

val separating : t -> plane option
(** After [Apart]: a plane nearly across the direction. Moves the last support. *)

(** What the edge of points 4 and 5 says of a line. *)
type beside =
  | Never of plane  (** it is an edge of the silhouette, and the line passes along it or outside *)
  | Crosses  (** the line passes strictly on the side of the centre *)
  | Unknown

val beside : t -> beside

val facet : t -> plane option
(** The plane of the portal, if it supports the obstacle and carries the three points. *)

val time : t -> plane -> Rat.t
(** When the line crosses the plane. n.w is not 0. *)

(** Where a line crosses the portal: what is not outside proves as well that the portal is a triangle, and not
    seen edge-on. *)
type crossing =
  | Within  (** strictly inside *)
  | Border of int  (** on its boundary; one of the corners that it is a combination of *)
  | Outside

val crossing : t -> crossing
(** Of the line of a cast. *)

val foot : t -> plane -> crossing
(** Of the line through the origin along the normal of the plane, which holds the origin. *)

val tight : t -> int -> Ivec.t list
(** [tight c k], when {!foot} is [Border k] in a plane that holds the origin: the normals of all facets that
    hold the origin, outward and primitive, each once. *)

val interior : t -> bool
(** Whether the line of a cast passes between points 4 and 5 as seen from the centre, and strictly before them:
    then it runs through the interior of the obstacle. *)

val inside : t -> bool
(** After [Inside]: whether the origin lies in the cone from the centre over the portal and strictly before it:
    then it is in the interior of the obstacle. *)
