(** Corners within edges. *)

open Scc_geometry

val make : Polyhedron.ifs -> Polyhedron.ifs * int
(** [make set] has, within edges, the corners of other faces that are there: a face takes them in, in their order.
    This is done along edges that do not have as many faces one way as the other way, and with corners of such
    edges. So nothing changes where faces are closed. Of several vertices at one place, one whose faces are
    connected with the face is taken. The number is that of faces which took in corners. *)
