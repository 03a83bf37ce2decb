(** A cache of how two bodies in translation are to each other on their paths (rule Blocked). On a lattice, kicks
    are few, and so are offsets: most queries have been made before. The answer depends on the two solids, the
    offset of one from the other, the velocities and the span alone. *)

open Scc_exact
open Scc_rigid
open Scc_semantics

type t

val create : unit -> t
(** An empty cache for at most 4096 answers. A new answer replaces the one in its slot ({!Scc_data.Recent}). *)

val find :
  t -> (Placed.t -> Placed.t -> span:Rat.t -> Vec.t -> Vec.t -> Geometry.paths) ->
  Placed.t -> Placed.t -> span:Rat.t -> Vec.t -> Vec.t -> Geometry.paths
(** [find cache paths one two ~span v u] is [paths one two ~span v u], from the cache if it is there, for solids
    that have not turned. Solids are compared by physical equality. *)
