(** From the refined calculus to the original one: features become regions, and solids sets of points. *)

open Scc_base
open Scc_syntax

val model : Ast.model -> (Ast.model, Diag.t list) result
(** A model of the language as a tree of the original notation ({!Tree}): a set of features is the union of the
    regions that they are; a template given by vertices and faces is the polyhedron of its points, each of its
    vertices a declared point of it and each face a declared polygon. All else stays as it is. Refused: names
    that are operators where regions stand (SC0360). *)
