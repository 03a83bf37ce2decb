(** The closed surfaces that faces make, and which of them are within which.

    Faces are of one shell if they hang together by edges. The solid of sound faces ({!Sound}) is in one piece iff
    one shell is around all others, turned outward, and these are its hollows, turned into them and beside each
    other: on either side of a shell, whoever is next to it gets to any other place next to it, past its edges. *)

open Scc_geometry

type fault =
  | Apart of int * int  (** a face of each of two solids that are beside each other *)
  | Island of int * int  (** a face of a solid, and one of the solid in a hollow of which it is *)
  | Outward of int  (** a face of a shell within a solid, whose faces are turned outward *)

val fault : Polyhedron.ifs -> fault option
(** Of sound faces. *)

val message : Polyhedron.ifs -> fault -> Scc_base.Code.t * string

val oriented : Polyhedron.ifs -> Polyhedron.ifs * int list
(** Each shell is turned outward that is within no other one or in a hollow, and inward that is within a solid.
    With the first face of each that had to be turned over. All stays as it is if there is one shell alone, or if
    faces are not sound for other reasons. Quadratic in the number of shells. *)
