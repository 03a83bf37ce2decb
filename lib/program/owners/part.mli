(** The states of one owner, numbered from 0 in the order in which they came, each with the way by which it was
    first found. States are stored as they are ({!Scc_graph_search.Tuples}), not as fingerprints. *)

open Scc_graph_search

type t

(** The last transition of a way to a state. *)
type way = {
  sender : int;  (** the owner of the state before *)
  before : int;  (** the state before: its rank among those of its level, or its number at its owner *)
  choice : int;  (** the place of the transition among those of that state *)
}

(** A goal that holds in a new state, for certain or perhaps. *)
type hit = { id : int; goal : int; sure : bool }

val make : ?clock:Clock.t -> Scc_successors.Filter.t -> t
(** No states yet. With [clock] it matters when states are reached. *)

val clock : t -> Clock.t option
(** The clock of {!make}. *)

val filter : t -> Scc_successors.Filter.t
(** The exploration that the states belong to. *)

val table : t -> Tuples.t
(** The states, which must be inserted by {!enter}. *)

val size : t -> int
(** The number of states. *)

val enter :
  t ->
  near:Tuples.spread ->
  Tuples.changes ->
  int array ->
  time:int ->
  instant:int ->
  sender:int ->
  before:int ->
  choice:int ->
  int
(** [enter p ~near changes target ~time ~instant ~sender ~before ~choice] is the number of the state [target],
    which differs by the changes from the one that is loaded in [near]. It is inserted if it is new. If it is
    not, but has come since {!close} was called, the way with the least [before] counts, and of several of these
    the one with the least [choice]. With a clock, [time] is the number of the time at which it is reached by
    this way. The earliest way counts, and of those of one round that are as early the first. [instant] is the
    number of transitions without duration with which the way ends. *)

val enter_initial : t -> home:int -> unit
(** [enter_initial p ~home] enters the initial state, which belongs to this owner, whose number is [home]. *)

val close : t -> unit
(** The ways of all states that are there are final. *)

val enter_prepared :
  t -> int -> int array -> time:int -> instant:int -> sender:int -> before:int -> choice:int -> unit
(** [enter_prepared p n target ~time ~instant ~sender ~before ~choice] is {!enter} for the [n]-th tuple of a
    round of {!table}. *)

val look_again : t -> int -> unit
(** The goals that hold in a state are among the next {!hits} again. *)

val again : t -> int -> time:int -> instant:int -> sender:int -> before:int -> choice:int -> unit
(** [again p id ~time ~instant ~sender ~before ~choice] is {!enter} for a state that is known to be there, with
    that number. *)

val way : t -> int -> way
(** How a state was first found. *)

val turns_at : t -> int -> unit
(** A transition without duration leads from a state to itself. *)

val turning : t -> int list
(** States such that each cycle of transitions without duration leads through one of them, at some owner, if each
    such transition was entered once in the round in which its source was expanded. *)

val keep_first : t -> unit
(** From now on the first way to each state that comes is final. *)

val instant : t -> int -> int
(** The number of transitions without duration with which the way to a state ends. *)

val is_too_long : t -> int -> bool
(** [is_too_long p i] is true if the state [i] has a number that is longer than the bound of bits: it is not to be
    expanded. *)

val found : t -> int -> unit
(** [found p goal]: the goal is met, and need not be looked for. *)

val hits : t -> hit list
(** The hits since the last call, in no order. *)
