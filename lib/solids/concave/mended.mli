(** Changes to a mesh on request, before it is examined or cut ({!Scc_mesh.Mend}). *)

open Scc_exact
open Scc_geometry

(** What is to be done, in this order. *)
type t = { grid : Rat.t option; weld : bool; orient : bool; merge : bool }

val apply : t -> Polyhedron.ifs -> (Polyhedron.ifs * (string * string) list, string) result
(** [apply t set] is the changed set, with the name of each change and a sentence on its effect. [Error] says why
    the faces cannot be oriented (SC0303). *)

val closing : Polyhedron.ifs -> Polyhedron_fault.t list -> Rat.t option
(** [closing set faults] is the distance of a grid on which gaps between faces close, if there are some and such a
    distance was found. *)

val merging : Polyhedron.ifs -> Polyhedron_fault.t list -> [ `Alone | `Welded ] option
(** [merging set faults] says whether merging alone, or after welding, leaves no edge that is in one face only
    ({!Scc_mesh.Mend.closing_merge}), if there are such edges. *)
