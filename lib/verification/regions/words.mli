(** The values for which a check holds, in words. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus

val number : Rat.t -> string
(** The exact number, and its decimal: ["4/25 = 0.16"]; ["7/18, about 0.3889"] if that is rounded; ["3"]. *)

val piece : Ranges.t -> Polyhedron.t -> string
(** The constraints of the piece within the box of the ranges, separated by commas, two bounds of one form
    together: ["x = y, -2 < z < 2"]. All of the box is ["everywhere"]. Constraints that the ranges imply are
    left out. *)

val without_extent : int -> string
(** The remark for a piece of a smaller dimension than the number of parameters: ["no length"] for 1, ["no
    area"] for 2, ["no volume"] for more. *)

val value : Ranges.t -> Chances.value -> string
(** A number, or what is known of it, as a function of the parameters: ["3/8"], ["5/2 - x"],
    ["from 0 to 3/8, not known better"]. *)

val not_known : string
(** The word for starts of which nothing is known. *)

val chances : Chances.t -> string
(** A probability or a mean over all starts in one line: its extremes and its mean, as
    ["0 to 3/8, for x in [0, 4\]; mean 3/16 = 0.1875"]. If nothing is known for some starts, it says that
    the extremes are those of all others. *)

val chances_lines : Chances.t -> string list
(** A probability or a mean over all starts by its pieces, as ["0 <= x < 2: 3/8"], and its mean in the last
    line. *)

val lines : Where.t -> string list
(** The lines of a report, without indentation:
    {v
    holds where
      -2 < y < 2, -2 < z < 2
    fails elsewhere
    probability 4/25 = 0.16
    v}
    Only the set with fewer pieces is described in full; the other one is the rest. Pieces without volume are
    marked. *)
