(** Bodies as declared: their places, parts and motions (Definition 4.4), before the network is composed. *)

open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type leaf = {
  name : string;
  process : int;  (** the process that declares it *)
  shape : Shape.t;
  parts : Model.part array;
  mass : Rat.t;
  fixed : bool;
  absorbs : bool;  (** as of {!Model.leaf} *)
  place : Form.place;  (** of its reference point *)
  position : Vec.t;  (** the same at {!Context.point} *)
  velocity : Vec.t;  (** of its own centroid *)
  spin : Vec.t;
  behaviour : (Env.t * Ast.behaviour) option;
  span : Span.t;
}

type process = {
  name : string;
  labelled : bool;  (** its leaves have names of their own *)
  members : int list;
  bonds : (Env.t * Ast.bond) list;
  span : Span.t;
}

type t = {
  leaves : leaf option array;  (** [None] for one with faults, which are reported *)
  processes : process array;
  registry : Registry.t;
}

val centroid : leaf -> Vec.t
(** In the world. *)

val read : Context.t -> Program.body list -> t
