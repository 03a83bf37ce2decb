(** Regions of contact: sets of points of a shape's surface, as written. *)

open Scc_base
open Scc_syntax

type t = { kind : kind; at : Span.t }

and kind =
  | Named of Ast.path  (** a feature, or a region that is declared *)
  | Hull of Ast.path list  (** [hull(a, b)]: of vertices, an edge or a face *)
  | Interior of t  (** [interior(top)]: a feature without its edges and corners *)
  | Polygon of Ast.expr list  (** [polygon(p, q, r, …)]: corners in order, either way round *)
  | Segment of Ast.expr * Ast.expr
  | Point of Ast.expr
  | Half of Ast.expr * Ast.expr  (** [half(n, d)]: the points x of the surface with n.x >= d *)
  | Cap of Ast.expr * Ast.expr  (** [cap(axis, c)] of a curved solid: see {!Extent} *)
  | Whole  (** [surface()] *)
  | Empty  (** [empty()] *)
  | Union of t * t
  | Common of t * t
  | Less of t * t

val read : Ast.expr -> (t, Diag.t) result
(** Reads an expression as a region. Any other expression is SC0360. *)

val members : t -> Ast.member list option
(** The features of a region that is written as a union of features, and [None] for any other region. *)

val of_members : Span.t -> Ast.member list -> (Ast.expr, Diag.t) result
(** The region of a set of features, which {!members} reads back. A feature whose name is an operator in a
    region is SC0360. *)

val of_feature : Ast.feature -> (Ast.expr, Diag.t) result
(** The region of one feature, as by {!of_members}. *)

val faults : Ast.model -> Diag.t list
(** The errors of {!read} for all regions of a tree ({!Tree}). *)
