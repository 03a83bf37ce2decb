(** The attributes of bodies and parts: [mass], [velocity], [spin], [at] (Definition 4.4). *)

open Scc_base
open Scc_exact
open Scc_syntax

type t = {
  mass : (Rat.t * Span.t) option;  (** positive *)
  velocity : (Vec.t * Span.t) option;
  spin : (Vec.t * Span.t) option;
  absorb : Span.t option;  (** the place of the word *)
  at : Placement.t;  (** the identity when not given *)
  complete : bool;  (** true if all attributes could be read *)
}

val read : Report.t -> Env.t -> Ast.attribute list -> t
(** Reads attributes, each kind at most once (SC0212). Faults are reported; [complete] is then false. *)

val velocity : t -> Vec.t
(** The velocity of the centre of mass, in the world; zero if none is given. *)

val spin : t -> Vec.t
(** The angular velocity in the world, in radians per unit of time; zero if none is given. *)
