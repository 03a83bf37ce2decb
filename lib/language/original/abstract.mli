(** From the refined calculus to the original one: features become regions, and solids sets of points. *)

open Scc_base
open Scc_syntax

val model : Ast.model -> (Ast.model, Diag.t list) result
(** [model m] is a model of the language as a tree of the original notation ({!Tree}). A set of features becomes
    the union of their regions. A template by vertices and faces becomes the polyhedron of its points; each
    vertex is then a declared point of it and each face a declared polygon. The rest is unchanged.

    A name that is an operator in a region is SC0360. A face with an unknown vertex is SC0203. *)
