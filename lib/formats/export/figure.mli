(** The look of bodies: their solids, and the colours of their families. *)

open Scc_exact
open Scc_geometry
open Scc_calculus

(** Leaves that look alike ({!Scc_calculus.Families}): all of them are fixed, or none is. *)
type family = {
  name : string;
  solid : bool;  (** opaque; fixed bodies are transparent, since they would hide the bodies within them *)
  rgb : int * int * int;  (** sRGB components from 0 to 255 *)
  linear : float array;  (** [rgb] as linear light, from 0 to 1 *)
}

val numbering : unit -> ('a -> (int -> 'b) -> int) * (unit -> 'b array)
(** [numbering ()] gives numbers from 0 to keys, which are plain data, in the order in which they come. The first
    function takes a key, and what makes an item of its number if the key is new. The second returns all items. *)

(** The families, meshes and forms of a model. *)
type t

val make : Model.t -> t
(** The figure of a model. *)

val families : t -> family array
(** The families, in the order of their first leaves. *)

val family : t -> leaf:int -> int
(** The index of the family of a leaf. *)

val hex : family -> string
(** The colour as ["#rrggbb"]. *)

val opacity : family -> float
(** 1 for an opaque family, and 0.35 for fixed bodies. *)

val meshes : t -> (Solid.t * int) array
(** The meshes to draw: each is a solid, and the index of the family that gives its colour. *)

val mesh : t -> leaf:int -> part:int -> int
(** The index in {!meshes} of a part of a leaf. *)

val forms : t -> int array
(** For each leaf, the first leaf that looks the same about its reference point. *)

val centre : Model.t -> State.t -> Vec.t
(** A point with integer coordinates near the middle of the bodies, or the origin unless that is far away.
    Floats of few digits are most exact relative to this point. *)

val extent : Model.t -> State.t -> (Vec.t * Vec.t) option
(** The least and the greatest coordinates of all corners in the world; [None] for a state without bodies. *)
