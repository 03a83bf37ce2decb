(** A cache of casts of solids that turn. In one state the same cast is computed several times, to find the
    collisions before and after a turn begins. From state to state of an exploration, most pairs keep their
    motions. The result of a cast depends on its arguments alone ({!Scc_rigid.Cast}). *)

open Scc_exact
open Scc_rigid

type t

val create : unit -> t
(** An empty cache for at most 8192 casts. A new cast replaces the one in its slot ({!Scc_data.Recent}). *)

val find :
  t -> (Motion.t -> Motion.t -> span:Rat.t -> grid:int -> phase:Rat.t -> Cast.outcome) ->
  Motion.t -> Motion.t -> span:Rat.t -> grid:int -> phase:Rat.t -> Cast.outcome
(** [find cache cast one two ~span ~grid ~phase] is [cast one two ~span ~grid ~phase], from the cache if it is
    there. Solids are compared by physical equality. *)
