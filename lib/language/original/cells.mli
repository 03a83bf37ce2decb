(** A shape cut so that its regions are unions of features. *)

open Scc_base
open Scc_exact
open Scc_syntax

type t

val max_pieces : int
(** 256. *)

val make : Extent.solid -> Scc_geometry.Polyhedron.t -> at:Span.t -> (Span.t * Extent.t) list -> t
(** The solid, cut along the planes that its regions ask for. Raises {!Fault.Found}: SC0366 for more than
    {!max_pieces}. *)

val is_cut : t -> bool

val members : t -> Span.t -> Extent.t -> Ast.member list
(** The features of the pieces that are in the region, which is their union. A feature with all its edges and
    corners is listed by itself, others with [only]. Empty if no point of the surface is in the region. *)

val fractions : t -> Rat.t list
(** The volumes of the pieces as fractions of the whole. *)

val items : t -> Ast.name -> Ast.item list
(** The shapes that the pieces are, and the compound of that name that they make: with one parameter, the mass. *)

val face_area : t -> int -> Rat.t * Rat.t
(** For the tests: the square of twice the area of that face of the whole, and of what the pieces have of it
    together. *)
