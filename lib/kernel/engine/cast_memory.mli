(** A memory of casts of solids that turn. In one state the same cast is asked for several times, to see who
    collides before and after a turn begins; and from state to state of an exploration most pairs go on as they
    did. The answer is a function of what is asked alone ({!Scc_rigid.Cast}). *)

open Scc_exact
open Scc_rigid

type t

val create : unit -> t
(** Bounded: what was asked long ago is forgotten. *)

val find :
  t -> (Motion.t -> Motion.t -> span:Rat.t -> grid:int -> phase:Rat.t -> Cast.outcome) ->
  Motion.t -> Motion.t -> span:Rat.t -> grid:int -> phase:Rat.t -> Cast.outcome
(** What the function answers, or has answered to the same. *)
