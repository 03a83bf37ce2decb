(** Inflatable icons (section 6 of the paper; Repenning 2005): from a picture of a silhouette to a solid. *)

open Scc_base
open Scc_exact
open Scc_pixels

type options = {
  background : int option;  (** a colour, 0xRRGGBB ({!Silhouette.find}) *)
  piece : int option;  (** of several, from 1, by size *)
  strength : Rat.t;  (** of all colours that are not told *)
  colours : (int * Rat.t) list;  (** strengths of the pixels of these colours *)
  shaded : bool;  (** the strength of a pixel goes with how dark it is *)
  profile : Relief.profile;
  faces : int option;  (** at most so many, or all *)
  scale : Rat.t;  (** the length of a pixel, more than 0 *)
}

type t = { relief : Relief.t; solid : Solid_of.t }

val make : progress:(string -> float -> unit) -> path:string -> options -> Raster.t -> (t, Diag.t) result
(** [progress] is told what is done, and which share of it. Errors: SC0343 when nothing is drawn, SC0344 when it
    is in several pieces, SC0345 when strengths, colours or the number of faces do not fit the drawing. *)
