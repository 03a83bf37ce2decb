(** Searches with hash compaction: little memory, and never a proof that there is nothing to find. *)

open Scc_ctl
open Scc_exact
open Scc_graph_search
open Scc_semantics

(** A run that meets a goal, replayed: where it leads, and the moment in the time transition from there, if it
    is not the state itself, with an offset at which the goal holds. *)
type met = { choices : int list; during : (Timeline.moment * Algebraic.t) option }

type answer =
  | Met of met
  | Unmet of string option  (** the goal could not be decided somewhere, for this reason *)

type result = {
  answers : answer list;  (** in the order of the goals *)
  states : int;
  transitions : int;
  depth : int;
  arrival : Rat.t;
  left : Transition.fault Explore.reason list;
  omission : float;
  bytes : int;
}

val search :
  ?expanding:State_fingerprints.expanding ->
  Limits.t -> Limits.surroundings -> Network_lts.context -> capacity:int -> rests:(int array -> bool) ->
  On_the_fly.predicate list -> result
(** Ends when all goals have been met. Choices are those among the transitions of {!Network_lts}. *)
