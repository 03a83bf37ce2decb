(** The closed surfaces that faces form, and their nesting.

    A shell is a set of faces that are connected by edges. The solid of sound faces ({!Sound}) is in one piece
    iff one shell, turned outward, contains all others, and these are its hollows. Shells of hollows are turned
    into them and are beside each other. The reason: all places next to one side of a shell are connected, past
    its edges. *)

open Scc_geometry

type fault =
  | Apart of int * int  (** a face of each of two solids that are beside each other *)
  | Island of int * int  (** a face of a solid, and a face of another solid that has the first one in a
                             hollow *)
  | Outward of int  (** a face of a shell within a solid, whose faces are turned outward *)

val fault : Polyhedron.ifs -> fault option
(** [fault set], for sound faces, is a reason why their solid is not in one piece; [None] if it is. *)

val message : Polyhedron.ifs -> fault -> Scc_base.Code.t * string
(** The code and the message of a fault, with the names of the faces. *)

val solids : Polyhedron.ifs -> Polyhedron.ifs list
(** [solids set] is the solids of a surface by themselves, each with its hollows, in the order of the first faces
    of their outer shells. The faces are those of {!United.surface}. Solids that share an edge are one. Quadratic
    in the number of shells if most of them are hollows. *)
