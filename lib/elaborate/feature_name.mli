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

val on_shape : Report.t -> own:string option -> Shape.t -> t -> Site.t option
(** The feature on a shape: [right] on a basic shape, [left.right] on a compound, where a bare name is SC0408.
    The name of the leaf itself, if given, may come first. SC0203 when the shape has no such feature. *)

val closure : Shape.t -> Site.t list -> Site.t list
(** Definition 4.2, part by part. *)
