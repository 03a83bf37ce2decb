(** How often faces surround the places beside them.

    A face counts once where a ray from a place leaves through it, and minus once where the ray enters. So outside
    of a solid whose faces look outward the count is 0, and 1 inside. Inside of one that is inside out it is -1. *)

open Scc_decompose

type t

val make : tick:(unit -> unit) -> Sheets.t array -> t
(** All that polygons of closed faces have in common ({!Sheets.met}); [tick] is called for each pair. *)

val met : t -> int -> Sheets.met
(** What a polygon has in common with the others. *)

val patch : t -> int -> int
(** The number of a polygon which stands for a polygon that others neither cut nor touch, but for common edges and
    corners. The counts beside both are the same. *)

(** Polygons with what they add to a count. A polygon may be there several times. *)
type count = (int * int) list

type sides = { behind : count; front : count }

val sides : t -> int -> Homogeneous.t array -> sides option
(** [sides space k piece] is the counts on both sides of a piece of polygon [k] that no other one cuts. Where
    several polygons of one direction cover the piece, it is [None] for all but the first of them. *)

val total : count -> int
(** [total count] is the sum of what all polygons add: how often a place is surrounded. *)

val of_pieces : int array -> count -> (int * int) list
(** [of_pieces pieces count] is what each piece adds to a count, in order and without zeros. The array has the
    piece of each polygon. *)
