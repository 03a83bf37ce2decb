(** Marks on what is painted: features whose channels are open, bonds, names. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_svg

val open_features : Paint.t -> Palette.rgb -> int -> Placed.t -> Feature.t list -> string list
(** Features of a solid of the view, which is placed there and has that colour, where they are seen: faces are
    hatched, edges are thick, vertices are rings. *)

val hatch : Paint.t -> string
(** The identifier of the hatch. *)

val pattern : Paint.t -> string list
(** Its definition, which a picture with open features needs. *)

val bond : Paint.t -> told:string -> Placed.t * Feature.t -> Placed.t * Feature.t -> string list
(** A line from the middle of one solid to that of the other over a dot between their features, in front of
    everything: where solids touch nothing is seen. *)

val bond_colour : string

(** A name and where it may be written: in the picture, and how much is seen of what it names. *)
type name = {
  text : string;
  at : (Rat.t * Rat.t) list;
  size : float;
  style : (string * string) list;  (** attributes *)
}

val names : width:int -> name list -> string list
(** Names that do not cover each other, those of what is seen best first; each at the first of its places that is
    free, or nowhere. *)
