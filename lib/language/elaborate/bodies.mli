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
  absorbs : bool;  (** as in {!Scc_calculus.Model.leaf} *)
  place : Form.place;  (** of its reference point, in the world *)
  position : Vec.t;  (** [place] at {!Context.point} *)
  velocity : Vec.t;  (** of its own centroid, in the world *)
  spin : Vec.t;
  behaviour : (Env.t * Ast.behaviour) option;
  span : Span.t;
}

type process = {
  name : string;
  labelled : bool;  (** its leaves have names of their own *)
  members : int list;
  bonds : (Env.t * Ast.bond) list;
}

type t = {
  leaves : leaf option array;  (** [None] for one with faults, which are reported *)
  processes : process array;
  registry : Registry.t;
}

val centroid : leaf -> Vec.t
(** The centroid of a leaf in the world, at {!Context.point}. *)

val read : Context.t -> Program.t -> t
(** Reads the bodies of a program. Leaves and processes are numbered in the order of declaration. A body with
    faults, which are reported, is [None]. *)
