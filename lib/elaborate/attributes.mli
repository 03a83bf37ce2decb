(** The attributes of bodies and parts: [mass], [velocity], [spin], [at] (Definition 4.4). *)

open Scc_base
open Scc_exact
open Scc_syntax

type t = {
  mass : (Rat.t * Span.t) option;  (** positive *)
  velocity : (Vec.t * Span.t) option;
  spin : Span.t option;  (** given; it is zero, or was reported *)
  at : Affine.t;  (** the identity when not given *)
  complete : bool;  (** whether all that was written could be read *)
}

val read : Report.t -> Env.t -> Ast.attribute list -> t
(** Each at most once (SC0212); a spin that is not zero is SC0902. *)

val velocity : t -> Vec.t
(** Zero when not given. *)
