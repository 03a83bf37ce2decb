(** From solids as written to accepted polyhedra (Definition 4.3, reading I-2), and from transformations of
    bodies to solids in space. *)

open Scc_syntax

val basic : Context.t -> Env.t -> label:string -> Ast.solid -> Shape.basic option
(** Elaborates a solid that is no compound (SC0210 otherwise). [label] is the name of the template if the solid
    is not derived from a named one. *)

val shape : Context.t -> Env.t -> label:string -> Ast.solid -> Shape.t option
(** Elaborates a solid that may also be the name of a compound. [label] is as in {!basic}. *)

val find : Context.t -> Env.t -> Ast.reference -> Shape.t option
(** The shape of a template by its name, or an instance of a family, which is made at its first use. An unknown
    name is SC0201. *)

val declare :
  Context.t -> Env.t -> Ast.head -> Ast.definitions -> (Env.t -> string -> Shape.t option) -> unit
(** [declare c env head definitions make] enters a template or a family of templates (SC0202 if the name is in
    use). [make] receives the scope with the definitions and the label. *)

type places
(** The places in the text of a solid, its vertices and its faces. *)

val places_of : Scc_base.Span.t -> (Ast.name * 'a) list -> (Ast.name * 'b) list -> places
(** [places_of whole vertices faces] is the places of a solid. A mesh has none for its vertices and faces. *)

val report_faults :
  Context.t ->
  ?mending:Ast.mending ->
  ?decomposed:bool ->
  places ->
  Scc_geometry.Polyhedron.ifs ->
  Scc_geometry.Polyhedron_fault.t list ->
  unit
(** Reports the faults of a polyhedron, each with its own code, at the feature that has it, or at the whole
    solid. With [mending], of a mesh, the hint names a word that would mend it, if there is one that is not there
    yet. What can be done about the whole mesh, as about several solids in it, is said with the fault that is
    told first, as for [decompose] if it is [decomposed]. *)

val face_span : places -> int -> Scc_base.Span.t
(** [face_span places i] is the place of the face [i], or of the whole solid if the face is not written. *)

val listed_set :
  Context.t -> Env.t -> (Ast.name * Ast.vector) list -> (Ast.name * Ast.name list) list ->
  Scc_geometry.Polyhedron.ifs option
(** Vertices and faces as written. The names must be distinct (SC0202), and the corners of faces must be
    vertices (SC0203). Nothing else is checked. *)

val declare_shape : Context.t -> Env.t -> Ast.head -> Ast.solid -> Ast.definitions -> unit
(** Enters the declaration [shape NAME = …]. *)

val read_unused : Context.t -> unit
(** Reads families without any instance, with unknown arguments, for the faults that do not depend on
    arguments. *)

val warn_off_centre : Context.t -> unit
(** Warns (SC0312) of each template that the model declares and uses, if its centroid is not the origin. Images
    of other templates are left out. *)
