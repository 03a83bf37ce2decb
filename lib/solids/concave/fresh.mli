(** Names that a set does not have yet. *)

open Scc_geometry

type t

val besides : Polyhedron.ifs -> t
(** [besides set] makes names that no vertex and no face of the set has. *)

val next : ?from:int -> t -> string -> string
(** [next t prefix] is the prefix with the least number such that neither the set nor an earlier call has this
    name. Numbers start at [from], which is 1 by default and always the same for a prefix. *)
