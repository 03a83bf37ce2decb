(** The solid of a shape that a text gives in plain numbers. *)

open Scc_geometry
open Scc_syntax

type t = { polyhedron : Polyhedron.t; round : Extent.round }

type shapes = { plain : Plain.t; setting : Setting.t; shape : string -> Ast.solid option }
(** The constants, how curved solids are taken, and the shapes that are declared without parameters. *)

val of_solid : shapes -> Ast.solid -> t
(** The solid of a template by vertices and faces, a hull, or a box, prism, antiprism or pyramid. It also reads
    a sphere, cylinder or cone, a declared shape, and any of these [scaled].

    Raises {!Fault.Found}: SC0362 for other solids and for numbers that are not plain, SC0111 for shapes nested
    more than 100 deep. *)
