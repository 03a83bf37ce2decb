(** The values of the states of an MDP, worked out as far as was asked, and a scheduler. *)

type t

type asked =
  | All
  | States of int list  (** some 10^6 others cost nothing when these do not lead to them *)

val value : t -> int -> Answer.t
(** Of a state. What was neither asked for nor is reached from that, and is not known from the graph, is only known
    to be possible. *)

val scheduler : t -> int array
(** A choice for each state, among the choices of that state and from 0 on: taken whenever it is visited, it
    attains the values, where those are exact; where they are intervals, its values are at least the lower ends for
    the greatest values, and at most the upper ends for the least ones (if those are known). Among the states that
    were asked for and what these lead to. *)

(** How the values were found that the graph does not tell. *)
type found =
  | By_graph  (** it told all *)
  | In_rationals
  | In_intervals of { sweeps : int; not_exact : Exact_solver.given_up option }
  | Given_up of Exact_solver.given_up

val found : t -> found

(** {1 For questions} *)

val solve :
  Backwards.t ->
  Equations.direction ->
  Effort.t ->
  asked:asked ->
  status:(int -> Equations.status) ->
  elsewhere:Answer.t ->
  allowed:(int -> bool) ->
  merged:Components.ends ->
  rewards:bool ->
  choice:(int -> int) ->
  t
(** As {!Equations.make}. [elsewhere] is the value of the states with that status; [choice] says of a state of
    known
    value which choice attains that (numbered through), or -1 when any does. Without [rewards] values are at most
    1. *)
