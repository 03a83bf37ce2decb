(** Proofs of what {!Portal} guesses, by signs of integers, which floats decide where a proved bound lets
    them. *)

open Scc_exact

type t
(** A question. *)

val make : Question.t -> Vec.t -> Vec.t -> t
(** [make question r w], with the offset and velocity of which the question has the floats. *)

type plane
(** A plane that is proved to support the obstacle, wherever B stands. *)

val normal : plane -> Ivec.t
(** Outward. *)

val height : t -> plane -> int
(** The sign of n.p for the points p of the plane: positive when the origin is strictly on the inner side. *)

val speed : t -> plane -> int
(** The sign of n.w. *)

val never : t -> plane -> bool
(** Whether the plane keeps the interiors apart, now and for all times to come. *)

val apart : t -> plane -> bool
(** Whether the plane keeps the closed bodies apart now. *)

val apart_forever : t -> plane -> bool
(** Whether the plane keeps the closed bodies apart, now and at all times, past and to come. *)

val separating : t -> Shadow.floats -> plane option
(** A plane nearly across the direction that seems to separate. *)

(** What an edge says of a line. *)
type beside =
  | Never of plane  (** it is an edge of the silhouette, and the line passes along it or outside *)
  | Crosses  (** the line passes strictly on the side of the centre *)
  | Unknown

val beside : t -> Portal.edge -> beside

val facet : t -> Portal.triangle -> plane option
(** The plane of a portal, if it supports the obstacle and carries the three points. *)

val time : t -> plane -> Rat.t
(** When the line crosses the plane. n.w is not 0. *)

(** Where a line crosses the portal: what is not outside proves as well that the portal is a triangle, and not
    seen edge-on. *)
type crossing =
  | Within  (** strictly inside *)
  | Border of Point.t  (** on its boundary; one of the corners that it is a combination of *)
  | Outside

val crossing : t -> Portal.triangle -> crossing
(** Of the line of a cast. *)

val foot : t -> plane -> Portal.triangle -> crossing
(** Of the line through the origin along the normal of the plane, which holds the origin. *)

val tight : t -> Point.t -> Ivec.t list
(** [tight c p], when {!foot} is [Border p] in a plane that holds the origin: the normals of all facets that
    hold the origin, outward and primitive, each once. *)

val interior : t -> Portal.edge -> bool
(** Whether the line of a cast passes between the ends of the edge as seen from the centre, and strictly before
    them: then it runs through the interior of the obstacle. *)

val inside : t -> Portal.triangle -> bool
(** Whether the origin lies in the cone from the centre over the portal and strictly before it:
    then it is in the interior of the obstacle. *)
