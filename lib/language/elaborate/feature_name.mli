(** From features as written to places on a shape. *)

open Scc_base
open Scc_syntax
open Scc_calculus

(** A feature with its indices evaluated: the names before the last one, and the last one or the tuple. *)
type t = {
  prefix : (string * Span.t) list;
  what : what;
  span : Span.t;
  env : Env.t;  (** where it is written *)
}

and what = Name of string * Span.t | Cycle of (string * Span.t) list

val read : Report.t -> Env.t -> Ast.feature -> t option
(** Evaluates the indices of a feature. The vertices of a tuple may have one common prefix; different prefixes
    are SC0203. *)

(** The meaning of a feature on a shape: one feature of one part, or all that show one feature of a drawn solid
    ({!Scc_concave.Parts}). *)
type meaning = {
  listed : Site.t list;  (** the list in channels: those of [closed] that are in the closure of no other one *)
  inside : Site.t list;  (** without the feature's edges and corners *)
  closed : Site.t list;  (** with the feature's edges and corners (Definition 4.2) *)
}

val on_shape : Report.t -> own:string option -> Shape.t -> t -> meaning option
(** The meaning of a feature on a shape: [right] on a basic shape, [left.right] on a compound. The name of the
    leaf itself, [own], may come first. An unknown feature is SC0203, and one inside another is SC0336. A bare
    name on a compound is SC0408, unless the compound is a drawn solid. *)

val one : meaning -> Site.t option
(** The site of a feature that is one feature of one part, and [None] for any other meaning. *)

val closed_by_parts : Shape.t -> meaning -> bool
(** [closed_by_parts shape m] is true if [m.closed] is exactly the union of the closures of [m.listed], each in
    its own part. *)
