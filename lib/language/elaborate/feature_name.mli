(** Features as written to places on a shape. *)

open Scc_base
open Scc_syntax
open Scc_calculus

(** A feature with its indices evaluated: the names before the last one, and the last one or the tuple. *)
type t = {
  prefix : (string * Span.t) list;
  what : what;
  span : Span.t;
}

and what = Name of string * Span.t | Cycle of (string * Span.t) list

val read : Report.t -> Env.t -> Ast.feature -> t option
(** Evaluates indices; the vertices of a tuple may carry one common prefix. *)

(** What a feature stands for on a shape: one feature of one part, or all that show one of a drawn solid
    ({!Scc_concave.Parts}). *)
type meaning = {
  listed : Site.t list;  (** as channels list it: of [closed] those that are in the closure of no other one *)
  inside : Site.t list;  (** without the feature's edges and corners *)
  closed : Site.t list;  (** with them (Definition 4.2) *)
}

val on_shape : Report.t -> own:string option -> Shape.t -> t -> meaning option
(** [right] on a basic shape, [left.right] on a compound, where a bare name is SC0408 but for drawn ones. The
    name of the leaf itself, if given, may come first. SC0203 when the shape has no such feature, SC0336 where
    it is inside another. *)

val one : meaning -> Site.t option
(** Of a feature of one part. *)

val closed_by_parts : Shape.t -> meaning -> bool
(** Whether [closed] is the closure of [listed] part by part, without leaving anything of it out. *)
