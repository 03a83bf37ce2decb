(** From the original calculus to the refined one: regions become features, and named solids polyhedra. *)

open Scc_base
open Scc_syntax

val model : Ast.model -> (Ast.model * (Span.t * string) list, Diag.t list) result
(** Of a tree of the original notation ({!Tree}) the model in the language. Rule *Regions* of the rule book
    tells how:

    - a region that is written as a union of features is the set of them;
    - a shape that has other regions is cut ({!Cells}), where they are no unions of its features, into the parts
      of a compound, whose mass is that of the body;
    - a polyhedron told by its points gets names for its vertices and faces ({!Points});
    - spheres, cylinders and cones become the polyhedra that the model says ({!Setting}).

    With it, what of the translation is not seen from it, each with the declaration that it is about: into how many
    parts a shape is cut, and how near the polyhedra are that stand for curved solids.

    All errors of regions, in order of the text, each once. Codes: those of {!Points}, {!Extent}, {!Setting},
    {!Cells}, {!Region}; SC0201, SC0202 (shapes that there are not, regions declared twice), SC0210 (regions in
    loops), SC0363 and SC0367. *)
