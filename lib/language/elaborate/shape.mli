(** The shapes of bodies: templates (Definition 4.3) and compounds of placed templates (Definition 4.5). *)

open Scc_base
open Scc_exact
open Scc_geometry

type basic = {
  id : int;  (** distinct for distinct polyhedra *)
  root : int;
  (** the [id] of the polyhedron of which this one is a scaled image; it has the same names and structure *)
  label : string;
  (** the name of the template; a shape scaled where it is used has that of the unscaled template *)
  polyhedron : Polyhedron.t;
}

type part = {
  name : string;
  basic : basic;
  placement : Affine.t;
  (** in the frame of the compound, at {!Context.point} *)
  place : Form.place;  (** its translation, for all values of parameters with ranges *)
  solid : Solid.t;  (** placed, but for the translation *)
  mass : Rat.t;
  span : Span.t;
}

type glue = { one : Scc_calculus.Site.t; two : Scc_calculus.Site.t }

type compound = {
  cid : int;
  clabel : string;
  parts : part array;
  open_glues : glue list;  (** between parts whose relative place depends on ranges *)
  velocity : Vec.t;  (** of the centre of mass; the default velocity of a process of this shape *)
  spin : Vec.t;  (** of every part; the default spin of a process of this shape *)
  drawn : Scc_concave.Parts.t option;  (** the meanings of features of the drawn solid itself *)
}

type t = Basic of basic | Compound of compound

val structure : t -> int
(** A number that is equal for shapes with the same parts and feature names: behaviours fit one iff they fit the
    other. *)

val label : t -> string
(** The name of the template or compound, with the indices or arguments of an instance. *)

val polyhedra : t -> Polyhedron.t array
(** The polyhedra of the parts, in body frames; one for a basic shape. *)

val part_index : compound -> string -> int option
(** The index of the part with this name. *)
