(** Inflatable icons (section 6 of the paper; Repenning 2005): from a picture of a silhouette to a solid. *)

open Scc_base
open Scc_exact
open Scc_pixels

type options = {
  background : int option;  (** a colour, 0xRRGGBB ({!Silhouette.find}) *)
  piece : int option;  (** of several, from 1, by size *)
  strength : Rat.t;  (** of all colours that are not in [colours] *)
  colours : (int * Rat.t) list;  (** strengths of the pixels of these colours *)
  shaded : bool;  (** the strength of a pixel is proportional to its darkness *)
  profile : Relief.profile;
  faces : int option;  (** at most so many, or all *)
  scale : Rat.t;  (** the length of a pixel, more than 0 *)
}

type t = { relief : Relief.t; solid : Solid_of.t }

val make : progress:(string -> float -> unit) -> path:string -> options -> Raster.t -> (t, Diag.t) result
(** The solid of a picture; [path] names the picture in errors. [progress] gets the name of the current step,
    and the share of it that is done. Errors: SC0343 for a drawing without pixels, SC0344 for several pieces,
    SC0345 for strengths, colours or a number of faces that do not fit the drawing. *)
