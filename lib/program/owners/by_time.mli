(** Owners that take states in the order of the earliest times at which they are reached, and states of one time
    step by step. The numbers, verdicts and runs are those of a single search in this order
    ({!Scc_ctl.On_the_fly}). So goals with bounds of time are decided. A round is the states of one time that are
    known when it begins. In each round there are three rounds of messages between all owners, as in {!In_step}. *)

open Scc_exact

(** What is asked, and how far it may go. *)
type settings = {
  searches : bool;  (** all that is asked are searches: it ends once none goes on *)
  within : Rat.t option array;  (** by goal: the time up to which it counts *)
  horizon : Rat.t option;  (** no state that is reached later is expanded *)
  most_states : int;
  most_rounds : int option;  (** of one time *)
}

type t

val make : Part.t -> Clock.t -> Mesh.t -> Expansion.t -> settings -> show:(Progress.t -> unit) ->
  settled:(t -> bool) -> t
(** One owner. The clock is that of its part. [show] is called after each round, and [settled] as in
    {!In_step.calls}. *)

val graph : t -> Cycles.graph
(** What has been explored. States are numbered by their turns. *)

val turns : t -> int
(** How many turns there have been, at all owners. *)

val run : t -> home:int -> Progress.t
(** The whole exploration, whose initial state is that of the owner [home]. *)
