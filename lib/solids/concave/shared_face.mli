(** Solids of one mesh that share a face. *)

open Scc_geometry

val advice : union:string -> Polyhedron.ifs -> string option
(** A line that names two faces with the same corners in the two directions, which the solids on both sides share,
    and says what takes such solids, which is [union]; [None] if there are none. Corners are the same if their
    positions are. *)
