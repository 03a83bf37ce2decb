(** Compounds that a drawn solid is cut into: [compound C = decompose "c.obj" mass 1]. *)

open Scc_syntax

val declare : Context.t -> Env.t -> Ast.head -> Ast.solid -> Ast.attribute list -> Ast.definitions -> unit
(** The parts are convex, disjoint, have the density of the whole, and are placed as the attributes say. Names
    of the solid's faces, vertices and edges are features of the compound ({!Shape.compound}[.drawn]). *)
