(** The solid that a shape is, where a text says it in plain numbers. *)

open Scc_geometry
open Scc_syntax

type t = { polyhedron : Polyhedron.t; round : Extent.round }

type shapes = { plain : Plain.t; setting : Setting.t; shape : string -> Ast.solid option }
(** The constants, how curved solids are taken, and the shapes that are declared without parameters. *)

val of_solid : shapes -> Ast.solid -> t
(** Of a template by vertices and faces, a hull, a box, prism, antiprism or pyramid, a sphere, cylinder or cone, a
    declared shape, and what is [scaled] of them. Raises {!Fault.Found}: SC0362 for all else, and for what is
    not told in plain numbers; SC0111 for shapes within one another beyond 100. *)
