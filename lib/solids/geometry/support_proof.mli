(** Proofs of what {!Portal} guesses, by signs of integers. Floats decide a sign where a proved error bound
    permits it. *)

open Scc_exact

type t
(** A question about the obstacle A - B at an offset r, where a line starts in the direction w. *)

val make : Question.t -> Vec.t -> Vec.t -> t
(** [make question r w] is the question with the exact offset [r] and velocity [w], whose floats are in
    [question]. *)

type plane
(** A plane that is proved to support the obstacle, wherever B stands. *)

val normal : plane -> Ivec.t
(** The outward normal. *)

val height : t -> plane -> int
(** The sign of n.p for the points p of the plane: positive if the origin is strictly on the inner side. *)

val speed : t -> plane -> int
(** The sign of n.w. *)

val never : t -> plane -> bool
(** [never c p] is true if the plane proves that the interiors are apart, now and at all later times. *)

val apart : t -> plane -> bool
(** [apart c p] is true if the plane proves that the closed bodies are apart now. *)

val apart_forever : t -> plane -> bool
(** [apart_forever c p] is true if the plane proves that the closed bodies are apart at all times, past ones
    included. *)

val separating : t -> Shadow.floats -> plane option
(** A supporting plane whose normal n is the given direction, rounded, and corrected so that n.w is not
    negative. [None] if no such plane is proved. *)

(** The position of a line relative to an edge. *)
type beside =
  | Never of plane  (** it is an edge of the silhouette, and the line passes along it or outside *)
  | Crosses  (** the line passes strictly on the side of the centre *)
  | Unknown

val beside : t -> Portal.edge -> beside
(** The position of the line of a cast relative to an edge of the silhouette. *)

val facet : t -> Portal.triangle -> plane option
(** The plane of a portal, if it supports the obstacle and contains the three points. *)

val time : t -> plane -> Rat.t
(** The time at which the line crosses the plane. The product n.w is not 0. *)

(** The point where a line crosses a portal. If it is not outside, the portal is proved to be a triangle that
    is not seen edge-on. *)
type crossing =
  | Within  (** strictly inside *)
  | Border of Point.t  (** on its boundary; one of the corners that it is a combination of *)
  | Outside

val crossing : t -> Portal.triangle -> crossing
(** The point where the line of a cast crosses the portal. *)

val foot : t -> plane -> Portal.triangle -> crossing
(** [foot c p portal] is the point where the line through the origin along the normal of [p] crosses the
    portal. The plane [p] contains the origin. *)

val tight : t -> Point.t -> Ivec.t list
(** [tight c p], when {!foot} is [Border p] in a plane through the origin, are the normals of all facets that
    contain the origin. They are outward, primitive and distinct. *)

val interior : t -> Portal.edge -> bool
(** [interior c edge] is true if the line of a cast passes between the ends of the edge as seen from the
    centre, and strictly before them. Then it runs through the interior of the obstacle. *)

val inside : t -> Portal.triangle -> bool
(** [inside c portal] is true if the origin lies in the cone from the centre over the portal and strictly
    before it. Then it is in the interior of the obstacle. *)
