(** What [scc shape] does to a mesh on request before it is looked at ({!Scc_mesh.Mend}). *)

open Scc_base
open Scc_geometry

type t

val term : t Cmdliner.Term.t
(** [--grid], [--weld], [--orient], [--merge]. *)

val apply : t -> Polyhedron.ifs -> (Polyhedron.ifs * string list, Diag.t list) result
(** In this order; with a line on each thing done. A surface of one side is SC0303. *)
