(** Gases of cubes in a box: the initial condition, drawn from a seed. *)

open Scc_exact
open Scc_calculus

type shapes =
  | Cubes  (** of side 1, all aligned, of one mass *)
  | Turned  (** of side 1, in six orientations *)
  | Mixed  (** three sizes, in four orientations, of one density *)

type body = {
  position : Vec.t;  (** of its centre *)
  velocity : Vec.t;
  half_size : Rat.t;
  mass : Rat.t;
  turn : int * int * int * int;  (** the quaternion w, x, y, z; not a unit *)
}

type t = {
  side : int;  (** of the box [0, side]^3 that holds the bodies *)
  bodies : body array;
}

val make : shapes -> count:int -> seed:int64 -> t
(** The density does not depend on the count. *)

val network : t -> Model.t * State.t
(** Leaf i is body i; six fixed leaves follow: the walls x = 0, x = side, y = 0, y = side, z = 0, z = side. *)

val write : out_channel -> t -> time:Rat.t -> unit
(** As the header of [gas.ml] tells. *)
