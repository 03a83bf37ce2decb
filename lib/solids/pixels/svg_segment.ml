(** The lines of a drawing, in units of the drawing, as a path has them. *)

open Scc_exact

type arc = {
  radii : Plane_map.point;
  angle : Rat.t;  (** of the first axis of the ellipse, in degrees *)
  large : bool;
  sweep : bool;  (** towards growing angles, from x to y *)
  stop : Plane_map.point;
}

type t =
  | Move of Plane_map.point  (** a new line begins here *)
  | Line of Plane_map.point
  | Curve of Plane_map.point list  (** a Bezier curve: the two or three control points after the place so far *)
  | Arc of arc
  | Close  (** back to where the line began *)

(** [outline f] calls [f] with each segment, in their order. *)
type outline = (t -> unit) -> unit
