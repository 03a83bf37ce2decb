(** The attributes of bodies and parts: [mass], [velocity], [spin], [at] (Definition 4.4). *)

open Scc_base
open Scc_exact
open Scc_syntax

type t = {
  mass : (Rat.t * Span.t) option;  (** positive *)
  velocity : (Vec.t * Span.t) option;
  spin : (Vec.t * Span.t) option;
  absorb : Span.t option;  (** where it says so *)
  at : Placement.t;  (** the identity when not given *)
  complete : bool;  (** whether all that was written could be read *)
}

val read : Report.t -> Env.t -> Ast.attribute list -> t
(** Each at most once (SC0212). *)

val velocity : t -> Vec.t
(** Zero when not given. *)

val spin : t -> Vec.t
(** Zero when not given. *)
