(** Solids as written to polyhedra that are accepted (Definition 4.3, reading I-2), and transformations of
    bodies to solids in space. *)

open Scc_syntax

val basic : Context.t -> Env.t -> label:string -> Ast.solid -> Shape.basic option
(** [label] is the template's name if this solid is not derived from a named one. *)

val shape : Context.t -> Env.t -> label:string -> Ast.solid -> Shape.t option
(** The same where a compound is allowed as well. *)

val find : Context.t -> Env.t -> Ast.reference -> Shape.t option
(** A template by its name, or one of a family, which is made when it is first asked for. *)

val declare :
  Context.t -> Env.t -> Ast.head -> Ast.definitions -> (Env.t -> string -> Shape.t option) -> unit
(** Enters a template or a family of them, each to be made in the scope of its definitions under its label (SC0202
    when the name is taken). *)

type places
(** Where the vertices and faces of a solid are written. *)

val places_of : Scc_base.Span.t -> (Ast.name * 'a) list -> (Ast.name * 'b) list -> places
(** The whole, its vertices and its faces; none of a mesh. *)

val report_fault : Context.t -> places -> Scc_geometry.Polyhedron.ifs -> Scc_geometry.Polyhedron_fault.t -> unit

val face_span : places -> int -> Scc_base.Span.t
(** Of the whole where the face is not written. *)

val listed_set :
  Context.t -> Env.t -> (Ast.name * Ast.vector) list -> (Ast.name * Ast.name list) list ->
  Scc_geometry.Polyhedron.ifs option
(** Vertices and faces as written: their names, and that faces are of the vertices, are checked and nothing
    else. *)

val declare_shape : Context.t -> Env.t -> Ast.head -> Ast.solid -> Ast.definitions -> unit
(** [shape NAME = …]. *)

val read_unused : Context.t -> unit
(** Families of which nothing uses an instance are read without arguments, for the faults that do not depend on
    them. *)

val warn_off_centre : Context.t -> unit
(** SC0312 for each declared template in use that is not centred and not an image of another. *)
