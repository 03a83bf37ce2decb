(** How an element of SVG is painted: what it says itself, and what it inherits. *)

open Scc_exact

type t = {
  fill : int option;  (** a colour, or nothing *)
  rule : Fill.rule;
  shown : bool;  (** visible, and at least half opaque *)
  displayed : bool;  (** of elements that are not, nothing inside is either *)
  opacity : Rat.t;  (** of all elements around together *)
  stroked : bool;
}

val initial : t

val of_element : t -> (string * string) list -> t
(** Of one with these attributes within one of that style. {!Svg_number.Bad} and {!Svg_number.Unread}. *)

val transform : string -> Plane_map.t
(** Of the attribute. *)
