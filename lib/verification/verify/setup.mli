(** How the checks of a model are explored: bounds, reductions, and what happens on the way. *)

open Scc_calculus
open Scc_graph_search
open Scc_state_space

type t = {
  bounds : Bounds.t;
  reductions : Reduction.kind list;
  compact : int option;
  (** hash compaction with room for so many states, for searches without a bound of time *)
  order : State_graph.order;
  (** of the exploration: with [By_steps] runs that decide a search have as few steps as possible, with
      [By_time] they end as early as possible *)
  surroundings : Limits.surroundings;
  observe : (State.t -> unit) option;  (** called with each new state, in order *)
  prove : bool;
  (** an invariant is searched for before anything is explored, in half of the time (rule Invariants).
      Otherwise, over zones, one is searched for only where exploration leaves a check open. *)
  contrast : bool;
  (** with the run of a verdict comes one that does otherwise ({!Scc_explain.Witness.otherwise}) *)
  curve : string option;
  (** the check with this name, which asks for a probability within a time, is answered for all shorter times, too
  *)
  parameter : Open_number.t option;
  (** probabilities and means are functions of this parameter (rule Parametric); draws must not be joined *)
  expanding : about:string -> State_graph.expanding;
  compacting : about:string -> State_fingerprints.expanding;
  (** the way of expanding with hash compaction. Both functions are called for each exploration. Its checks
      ({!Joint_check.about}) and the options determine it. Explorations with equal checks come in the same
      order. *)
}

val default : t
(** Default bounds, all reductions, by steps, in quiet surroundings. *)

(** A part of the seconds that are left when some work begins: that of [mine] of [all] checks. *)
type share

val shares : size:('a -> int) -> after:int -> 'a list -> ('a * share) list
(** [shares ~size ~after list] are the shares of work that is done in this order, where each element is about so
    many checks, and [after] more checks come after all of them. Time that is not used goes on to later work. *)

val share : t -> share -> t
(** [share t s] is for work that begins now and has the share [s] of the seconds that are left. *)

val in_rounds : t -> size:('a -> int) -> cut:('b -> bool) -> (t -> 'a -> 'b) -> 'a list -> 'b list
(** [in_rounds t ~size ~cut run list] is [run] of each element, in the order of [list], each with its share of the
    seconds. Those whose results are [cut], as their shares ended them, are run again as long as seconds are left,
    each with its share of these. *)
