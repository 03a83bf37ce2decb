(** What the passes of one elaboration share: the report, the templates, and caches of solids and obstacles. *)

open Scc_base
open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_syntax

type template = {
  shape : Shape.t option;  (** [None] when its faults have been reported *)
  span : Span.t;  (** of its name *)
  own : bool;  (** declared by the model, and not by what it imports *)
  declared : bool;  (** written so, and no instance of a family *)
  mutable used : bool;
}

(** A family of shapes or compounds: a declaration with indices or parameters. *)
type family = {
  head : Family.head;
  make : Family.reference -> Shape.t option;  (** makes an instance *)
  family_span : Span.t;
  family_own : bool;
  mutable instances : int;
}

(** A shape as declared, whose faces may enclose no solid. *)
type source = {
  scope : Env.t;
  source_head : Family.head;
  written : Ast.solid;
  definitions : Ast.definitions;
}

type t = {
  report : Report.t;
  read_file : string -> (string, string) result;
  templates : (string, template) Hashtbl.t;  (** by their global names, and instances by their labels *)
  made : (string, Shape.t option) Hashtbl.t;
  (** predefined solids by their labels, such as [box(1,2,3)], which are of no text *)
  families : (string, family) Hashtbl.t;  (** by keys *)
  sources : (string, source) Hashtbl.t;  (** by keys; no compounds *)
  mutable nesting : int;  (** the number of instances that are being made, one within another *)
  mutable root : Env.t;  (** of the model: its imports, and no values *)
  mutable point : Rat.t array;  (** the values of parameters with known ranges in the declared state *)
  obstacles : Obstacle_cache.t;
  fresh : unit -> int;  (** the next identity, from 0 *)
  solid : Shape.basic -> Mat.t -> Solid.t;  (** cached by template and linear map *)
  scaled : Shape.basic -> Vec.t -> Polyhedron.t * int;
  (** the scaled image and its [id], cached by template and factors *)
  touching : Obstacle.t -> Vec.t -> Contact.pair list;  (** [Contact.touching], cached by solids and offset *)
}

val create : read_file:(string -> (string, string) result) -> t
(** An empty context. [read_file] returns the text of a mesh or an import by its path, or why it cannot be
    read. *)

val copy : t -> t
(** A context with the same templates and diagnostics. Templates and diagnostics that one of the two gets
    later, and uses that it marks, are not in the other. Solids and obstacles are shared. *)

val mark_used : t -> by:t -> unit
(** [mark_used c ~by] marks the templates of [c] that are used in [by]. *)

val template_names : t -> string list
(** The keys of all templates and families of templates that are declared, sorted; no instances. *)
