(** What bodies look like: their solids, and the colours of their families. *)

open Scc_exact
open Scc_geometry
open Scc_calculus

(** The leaves that look alike ({!Families}), all or none of them fixed. *)
type family = {
  name : string;
  solid : bool;  (** not to be seen through: fixed bodies would hide what is within them *)
  rgb : int * int * int;  (** of 255, as screens take them (sRGB) *)
  linear : float array;  (** the same, as amounts of light *)
}

type t

val make : Model.t -> t
val families : t -> family array
val family : t -> leaf:int -> int

val hex : family -> string
(** ["#rrggbb"]. *)

val opacity : family -> float

val meshes : t -> (Solid.t * int) array
(** What there is to draw: solids, each in the colour of a family. *)

val mesh : t -> leaf:int -> part:int -> int

val forms : t -> int array
(** For each leaf the first leaf that looks the same, about its reference point. *)

val centre : Model.t -> State.t -> Vec.t
(** A point with integer coordinates near the middle of what there is, the origin unless that is far away: what
    floats of few digits are best told from. *)

val extent : Model.t -> State.t -> (Vec.t * Vec.t) option
(** The least and the greatest coordinates of all corners; [None] if there is nobody. *)
