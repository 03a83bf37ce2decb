(** The style of an element of SVG: its own properties, and those that it inherits. *)

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
(** The style outside of all elements: a black fill by the rule [Nonzero], visible, opaque, without a
    stroke. *)

val of_element : t -> (string * string) list -> t
(** [of_element around attributes] is the style of an element with these attributes within an element of the
    style [around]. Raises {!Svg_number.Bad} and {!Svg_number.Unread}. *)

val transform : string -> Plane_map.t
(** The map of the attribute [transform]. Raises {!Svg_number.Bad}. *)
