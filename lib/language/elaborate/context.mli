(** What one elaboration shares between its passes: the report, the templates, the solids and obstacles made
    so far. *)

open Scc_base
open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_syntax

type template = {
  shape : Shape.t option;  (** [None] when its faults have been reported *)
  span : Span.t;  (** of its name *)
  own : bool;  (** declared by the model, and not by what it imports *)
  mutable used : bool;
}

(** Shapes or compounds with parameters. *)
type family = {
  head : Family.head;
  make : Family.reference -> Shape.t option;  (** one of them *)
  family_span : Span.t;
  family_own : bool;
  mutable instances : int;
}

(** A shape as it was declared, for those who want its faces even if they enclose no solid. *)
type source = {
  scope : Env.t;
  source_head : Family.head;
  written : Ast.solid;
  definitions : Ast.definitions;
}

type t = {
  report : Report.t;
  read_file : string -> (string, string) result;
  templates : (string, template) Hashtbl.t;  (** by global names, and by the labels of instances *)
  families : (string, family) Hashtbl.t;  (** by keys *)
  sources : (string, source) Hashtbl.t;  (** by keys; no compounds *)
  mutable nesting : int;  (** how many instances are being made, one within another *)
  mutable root : Env.t;  (** of the model: its imports, and no values *)
  mutable point : Rat.t array;  (** where parameters of which ranges are known stand for the declared state *)
  obstacles : Obstacle_cache.t;
  fresh : unit -> int;  (** identities, from 0 *)
  solid : Shape.basic -> Mat.t -> Solid.t;  (** one for each template and linear map *)
  scaled : Shape.basic -> Vec.t -> Polyhedron.t * int;
  (** the scaled image and its [id]: one for each template and factors *)
  touching : Obstacle.t -> Vec.t -> Contact.pair list;  (** {!Contact.touching}, remembered *)
}

val create : read_file:(string -> (string, string) result) -> t

val template_names : t -> string list
(** Sorted. *)
