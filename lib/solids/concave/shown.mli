(** The faces, edges and corners of a drawn solid that the features of its convex parts show. *)

open Scc_geometry

type t

val make : Drawn.t -> t
(** An index of the surface for {!features}. *)

val features : t -> Polyhedron.t -> (Feature.t * Drawn.feature list) list
(** [features t part] has each feature of a part of the solid that is seen from outside, with what it shows. It
    shows several features if a face has pieces of several regions, or an edge continues from a border into a
    region. An edge or a corner inside a region shows that region. Features that other parts hide completely
    are not listed. *)

val faces : t -> Polyhedron.t -> (Feature.t * Drawn.feature list) list
(** The faces of the part among {!features}. *)
