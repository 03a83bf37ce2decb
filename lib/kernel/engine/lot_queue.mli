(** The lots of one instant, one decision after the other, in the order of {!Scc_semantics.Lots.due} (rule Lot).
    That function visits all processes with pending lots for each decision. A queue sorts these processes once:
    decisions change neither velocities nor places. *)

open Scc_calculus
open Scc_semantics

type t

val make : Model.t -> State.process list -> t
(** [make m processes] is the work for all processes of a state at which lots are pending, in order. There must be
    one. *)

val due : t -> Lots.due
(** The next action. *)

val draws : t -> bool
(** [draws t] is true if chance decides what is due. *)

val decide : t -> State.process -> unit
(** [decide t p] takes the next action, which must be a decision, [To_draw], [To_be_first] or [To_choose]. It made
    its process become [p]. After [To_release] a queue has no further use. *)

val is_over : t -> bool
(** [is_over t] is true if no lots are pending any more. Then nothing is due. *)
