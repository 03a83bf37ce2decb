(** Marks on painted solids: features with open channels, bonds, names. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_svg

val open_features : Paint.t -> Palette.rgb -> int -> Placed.t -> Feature.t list -> string list
(** [open_features t colour body placed features] marks features of a solid of the view where they are visible.
    Faces are hatched, edges are thick, and vertices are rings. [body] is the number of the solid, and [placed]
    its place. *)

val hatch : Paint.t -> string
(** The identifier of the hatch. Equal identifiers are of equal patterns. *)

val pattern : Paint.t -> string list
(** The definition of the hatch, which a picture with open features needs. *)

val bond : Paint.t -> told:string -> Placed.t * Feature.t -> Placed.t * Feature.t -> string list
(** A line between the middles of two solids over a dot between their features. It is in front of everything,
    since touching features are hidden. Its title is [told]. *)

val bond_colour : string
(** The colour of bonds, as ["#rrggbb"]. *)

(** A name with its possible places on the paper, and the visible area of its object. *)
type name = {
  text : string;
  at : (Rat.t * Rat.t) list;
  size : float;
  style : (string * string) list;  (** attributes *)
}

val names : width:int -> name list -> string list
(** Names that do not cover each other, within the width. Those of the largest objects are placed first, each at
    the first of its places that is free; a name without a free place is left out. *)
