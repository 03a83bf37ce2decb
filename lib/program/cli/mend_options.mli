(** What is done to a mesh on request before it is looked at or cut ({!Scc_mesh.Mend}). *)

open Scc_base
open Scc_geometry

type t

val term : t Cmdliner.Term.t
(** [--grid], [--weld], [--orient], [--merge]. *)

type told = (string * string) list
(** The name of each option that was given, with a line on what it did. *)

val apply : t -> Polyhedron.ifs -> (Polyhedron.ifs * told, Diag.t list) result
(** In this order. A surface of one side is SC0303. *)

val helping : Polyhedron_fault.t list -> string list
(** Which of these options may do away with some of the faults: [["--weld"; "--orient"]]. *)

val text : told -> string
(** Lines. *)
