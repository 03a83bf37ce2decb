(** Where convex parts of a solid touch each other with whole areas. *)

open Scc_geometry

type site = { part : int; face : int }

val forest : Polyhedron.t array -> (site * site) list
(** Of parts without common inner points: faces that have an area in common, as few pairs as join all parts
    that hang together so. These faces are the highest touching features of their parts, as convex parts have
    a plane between them. In the order of the parts. *)
