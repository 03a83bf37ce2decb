(** Solids as written to polyhedra that are accepted (Definition 4.3, reading I-2), and transformations of
    bodies to solids in space. *)

open Scc_syntax

val basic : Context.t -> Env.t -> label:string -> Ast.solid -> Shape.basic option
(** [label] is the template's name if this solid is not derived from a named one. *)

val shape : Context.t -> Env.t -> label:string -> Ast.solid -> Shape.t option
(** The same where a compound is allowed as well. *)

val declare : Context.t -> Env.t -> Ast.name -> Ast.solid -> unit
(** [shape NAME = …]. *)

val admit : Context.t -> Ast.name -> Shape.t option -> unit
(** Enters a template (SC0202 when the name is taken). *)

val warn_off_centre : Context.t -> unit
(** SC0312 for each declared template in use that is not centred and not an image of another. *)
