(** Inflatable icons (section 6 of the paper; Repenning 2005): from a picture of a silhouette to a solid. *)

open Scc_base
open Scc_exact
open Scc_pixels

(** What becomes of a drawing in several pieces. *)
type pieces =
  | Only of int option  (** one piece: of several the one with this number, from 1, by size *)
  | Apart  (** all, as a solid of several closed surfaces *)
  | Plate of Rat.t  (** all on a plate, whose height over the middle plane is this many pixels, more than 0 *)

type options = {
  background : int option;  (** a colour, 0xRRGGBB ({!Silhouette.find}) *)
  pieces : pieces;
  strength : Rat.t;  (** of all colours that are not in [colours] *)
  colours : (int * Rat.t) list;  (** strengths of the pixels of these colours *)
  shaded : bool;  (** the strength of a pixel is proportional to its darkness *)
  profile : Relief.profile;
  faces : [ `About of int | `Most of int | `All ];
  (** at most so many; with [`About] more, if the drawing cannot be had with so few *)
  scale : Rat.t;  (** the length of a pixel, more than 0 *)
}

type t = {
  relief : Relief.t;  (** of all pieces together *)
  solid : Solid_of.t;  (** all of it *)
  solids : Solid_of.t list;  (** what is connected, each by itself *)
}

val make : progress:(string -> float -> unit) -> path:string -> options -> Raster.t -> (t, Diag.t) result
(** The solid of a picture; [path] names the picture in errors. [progress] gets the name of the current step,
    and the share of it that is done. Errors: SC0343 for a drawing without pixels, SC0344 for several pieces,
    SC0345 for strengths, colours or a number of faces that do not fit the drawing. *)
