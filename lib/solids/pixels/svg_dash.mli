(** Lines cut into dashes. *)

open Scc_exact

(** What a pen draws in one go. *)
type run =
  | Ring of Svg_chain.strand list  (** closed *)
  | Open of Svg_chain.strand list  (** with two ends *)
  | Dot of Plane_map.point * Plane_map.point  (** a dash of length 0: its place and its direction *)

type pattern
(** Lengths of dashes and gaps in turn, and where in them a line begins. *)

val pattern : Rat.t list -> offset:Rat.t -> pattern
(** [pattern lengths ~offset]: an even number of lengths, none negative, not all 0. *)

val cut : budget:Svg_polygon.budget -> pattern -> Svg_chain.line -> run list
(** [cut ~budget pattern line] are the dashes of a line with strands. In a closed line, a dash that ends where
    one begins is one with it. Each end of a dash takes one from the budget. Lengths are those of chords, to
    forty bits. *)
