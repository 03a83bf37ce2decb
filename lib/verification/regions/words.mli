(** Where a check holds, in words. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus

val number : Rat.t -> string
(** The exact number, and the decimal: ["4/25 = 0.16"]; ["7/18, about 0.3889"] where that is rounded; ["3"]. *)

val probability : Where.probability -> string
(** ["4/25 = 0.16"]; ["at least 1/9, about 0.1111, and at most 1/2 = 0.5"]. *)

val piece : Ranges.t -> Polyhedron.t -> string
(** What describes the piece within the box of the ranges, separated by commas, two borders of one form
    together: ["x = y, -2 < z < 2"]; ["everywhere"] if it is all of the box. What the ranges say is left out. *)

val without_extent : int -> string
(** What a piece of a smaller dimension lacks among so many parameters: ["no length"], ["no area"],
    ["no volume"]. *)

val lines : Where.t -> string list
(** Of a report, in lines to be indented by whoever prints them:
    {v
    holds where
      -2 < y < 2, -2 < z < 2
    fails elsewhere
    probability 4/25 = 0.16
    v}
    Of the two the one with fewer pieces is told, the other one is what is left. Pieces without volume say so. *)
