(** Compounds made by cutting a drawn solid: [compound C = decompose "c.obj" mass 1]. *)

open Scc_syntax

val declare : Context.t -> Env.t -> Ast.head -> Ast.solid -> Ast.attribute list -> Ast.definitions -> unit
(** Enters such a compound among the templates. Its parts are convex and disjoint, have the density of the
    whole, and are placed by the attributes. The names of the solid's faces, vertices and edges are features of
    the compound ({!Shape.compound}[.drawn]). *)
