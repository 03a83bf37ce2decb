(** From the original calculus to the refined one: regions become features, and named solids become
    polyhedra. *)

open Scc_base
open Scc_syntax

val model : Ast.model -> (Ast.model * (Span.t * string) list, Diag.t list) result
(** Translates a tree of the original notation ({!Tree}) into the language, by rule *Regions* of the rule book.

    - A region that is written as a union of features becomes the set of these features.
    - A shape with other regions, if they are no unions of its features, is cut ({!Cells}). Its pieces become the
      parts of a compound with the mass of the body.
    - A polyhedron given by its points gets names for its vertices and faces ({!Points}).
    - Spheres, cylinders and cones become the polyhedra that the model sets ({!Setting}).

    The second result is notes with the places of declarations. They give the number of parts of each shape that
    is cut, and the distance of polyhedra from the curved solids that they replace.

    The errors of regions are in the order of the text, each once, at most {!Scc_syntax.Parse.max_errors}. Codes:
    those of {!Points}, {!Extent}, {!Setting}, {!Cells} and {!Region}; SC0201 (unknown shapes), SC0202 (regions
    declared twice), SC0210 (regions in loops), SC0363 and SC0367. *)
