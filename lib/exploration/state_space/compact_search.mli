(** Searches with hash compaction. They take little memory, and never prove that there is nothing to find. *)

open Scc_ctl
open Scc_exact
open Scc_graph_search
open Scc_semantics

(** A run that meets a goal. [choices] is the transitions that lead to a state, by their indices. If the goal
    does not hold at the state itself, [during] is the moment in the time transition from there, with an offset
    at which it holds. *)
type met = { choices : int list; during : (Timeline.moment * Algebraic.t) option }

type answer =
  | Met of met
  | Unmet of string option  (** the goal could not be decided somewhere, for this reason *)

type result = {
  answers : answer list;  (** in the order of the goals *)
  states : int;  (** the number of states found *)
  transitions : int;
  depth : int;  (** the greatest number of transitions on the path to a state *)
  arrival : Rat.t;  (** the greatest model time of these paths *)
  left : Transition.fault Explore.reason list;  (** why some states were not expanded *)
  omission : float;  (** a bound on the probability that some state was left out unseen *)
  bytes : int;  (** the memory of the table of states *)
}

val search :
  ?expanding:State_fingerprints.expanding ->
  Limits.t -> Limits.surroundings -> Network_lts.context -> capacity:int -> rests:(int array -> bool) ->
  On_the_fly.predicate list -> result
(** [search limits around context ~capacity ~rests goals] explores states until all goals have been met, or a
    limit ends it. At most [capacity] states are kept. [rests] is true for a state without transitions in which
    time passes for ever. Choices are indices into {!Network_lts.successors}. *)
