(** Contacts of the convex parts of a solid in whole areas. *)

open Scc_geometry

type site = { part : int; face : int }

val forest : Polyhedron.t array -> (site * site) list
(** [forest parts], of parts without common inner points, are pairs of faces that share an area. There are as
    few pairs as needed to join all parts that such pairs connect. The faces of a pair are the highest touching
    features of their parts, since a plane separates convex parts. In the order of the parts. *)
