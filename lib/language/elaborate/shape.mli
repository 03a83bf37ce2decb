(** The shapes that bodies are made of: templates (Definition 4.3) and compounds of placed templates
    (Definition 4.5). *)

open Scc_base
open Scc_exact
open Scc_geometry

type basic = {
  id : int;  (** distinct for distinct polyhedra *)
  root : int;
  (** the [id] of the polyhedron that this one is a scaled image of: names and structure are its *)
  label : string;
  (** the template's name; for a shape scaled where it is used, that of what it is scaled from *)
  polyhedron : Polyhedron.t;
}

type part = {
  name : string;
  basic : basic;
  placement : Affine.t;
  (** in the frame of the compound; for one of the values that parameters with ranges may have *)
  place : Form.place;  (** its translation, for all of them *)
  solid : Solid.t;  (** placed, but for the translation *)
  mass : Rat.t;
  span : Span.t;
}

type glue = { one : Scc_calculus.Site.t; two : Scc_calculus.Site.t }

type compound = {
  cid : int;
  clabel : string;
  parts : part array;
  open_glues : glue list;  (** of parts that are not at a known place from each other *)
  velocity : Vec.t;  (** of the centre of mass; a process of this shape that gives none has it *)
  spin : Vec.t;  (** of every part; likewise *)
  drawn : Scc_concave.Parts.t option;  (** what names of features stand for that are not of one part *)
}

type t = Basic of basic | Compound of compound

val structure : t -> int
(** Equal for shapes with the same parts and feature names: behaviours fit one iff they fit the other. *)

val label : t -> string

val polyhedra : t -> Polyhedron.t array
(** Of the parts; one for a basic shape. *)

val part_index : compound -> string -> int option
