(** Changes to a mesh on request, before it is examined or cut ({!Scc_mesh.Mend}). *)

open Scc_exact
open Scc_geometry

(** What is to be done, in this order. *)
type t = { grid : Rat.t option; weld : bool; orient : bool; merge : bool }

val apply : t -> Polyhedron.ifs -> (Polyhedron.ifs * (string * string) list, string) result
(** [apply t set] is the changed set, with the name of each change and a sentence on its effect, in the order of
    the fields. [Error] says why the faces cannot be oriented (SC0303).

    Merging has two steps: corners within edges of other faces become corners of these ({!Fitted}), before faces
    are oriented, since a piece is only turned if it is closed. Where all pieces are closed before
    they are welded, they are turned first ({!Oriented}): solids that share a face are told apart by their
    vertices. *)

val closing : Polyhedron.ifs -> Polyhedron_fault.t list -> Rat.t option
(** [closing set faults] is the distance of a grid on which gaps between faces close, if there are some and such a
    distance was found. *)

val merging : Polyhedron.ifs -> Polyhedron_fault.t list -> [ `Alone | `Welded ] option
(** [merging set faults] says how merging leaves no edge that is in one face only, if there are such edges: alone,
    or after welding. [None] if it does not. Where a corner of one face is within an edge of another one, the edges
    beside it are in one face each. *)

val one_side_each : Polyhedron.ifs -> bool
(** True for faces that are there from both sides, if one of both each leaves a solid after welding. *)
