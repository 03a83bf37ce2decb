(** A shape that is cut so that each of its regions is a union of features. *)

open Scc_base
open Scc_exact
open Scc_syntax

(** A shape, whole or in pieces. *)
type t

val make : Extent.solid -> Scc_geometry.Polyhedron.t -> at:Span.t -> (Span.t * Extent.t) list -> t
(** [make solid p ~at regions] is the solid [p], cut along the planes of its regions. Raises {!Fault.Found}:
    SC0366 at [at] for more than 256 pieces. *)

val is_cut : t -> bool
(** [is_cut t] is true if the shape has more than one piece. *)

val members : t -> Span.t -> Extent.t -> Ast.member list
(** [members t at region] is the features of the pieces whose union is the region. A feature is listed by itself
    if all its edges and corners are in the region, and with [only] otherwise. The list is empty if no point of
    the surface is in the region. *)

val fractions : t -> Rat.t list
(** The volumes of the pieces as fractions of the whole. *)

val items : t -> Ast.name -> Ast.item list
(** [items t name] is the shapes of the pieces and their compound [name], which has one parameter: the mass. *)
