(** Changes to a mesh on request, before it is examined or cut ({!Scc_mesh.Mend}). *)

open Scc_base
open Scc_geometry

(** The options as given. *)
type t

val term : t Cmdliner.Term.t
(** The options [--grid], [--weld], [--orient] and [--merge]. *)

type told = (string * string) list
(** The name of each option that was given, with a line on its effect. *)

val apply : t -> Polyhedron.ifs -> (Polyhedron.ifs * told, Diag.t list) result
(** Applies the options, in this order. A surface of one side is SC0303. *)

val helping : Polyhedron.ifs -> Polyhedron_fault.t list -> string list
(** The options that may remove some of the faults, such as [["--weld"; "--orient"]]. *)

val all_helping : Polyhedron.ifs -> Polyhedron_fault.t list -> string list
(** [all_helping set faults] are the options of {!helping}, and before them those that close edges of one face:
    a grid ({!Scc_mesh.Mend.closing_grid}) with [--weld]. Grids are tried for at most 100 000 faces. *)

val of_inside_out : Polyhedron.ifs -> string
(** The hint for pieces that are inside out. *)

val of_nothing : Polyhedron.ifs -> string
(** The hint for closed faces that surround nothing. *)

val text : told -> string
(** The effects as lines of text. *)
