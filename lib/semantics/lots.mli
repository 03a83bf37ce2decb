(** Which bonds lots are drawn for, and when (rule Lot). What comes of them is told by {!Splits.lots}. *)

open Scc_exact
open Scc_calculus

(** One end of a bond that lots are drawn for. *)
type side = {
  finish : State.finish;
  drawn : (Behaviour.t * Rat.t) list;
  (** its summands that release the bond by chance, each with its probability, more than 0; where there are none it
      is free to choose among its others *)
}

val sides : Model.t -> State.process -> State.bond -> (side * side) option
(** The ends of a bond, the lesser one first, if lots are drawn for it: both would release it, and one of them
    has a chance to. *)

val wait : Model.t -> State.process -> Rat.t option
(** The time until the next split instant of the network, if lots would be drawn then for a bond of the process. *)

val start : Model.t -> State.process -> State.process
(** At the start no lots are drawn. *)

val pass : Model.t -> Rat.t -> State.process -> State.process
(** [pass m d p]: a time d > 0, no more than {!wait}, has passed for what has aged already. Where that comes to a
    split instant, all its bonds that lots are drawn for are pending. *)

val piece : Model.t -> whole:State.process -> State.process -> State.process
(** A piece goes on with those lots of the whole that are about its bonds and that its leaves would still follow.
*)

val is_pending : State.process -> bool
val pending : State.t -> bool
(** Whether something is to be drawn or released now, of one process or of any. *)

val next : Model.t -> State.t -> State.process option
(** Whose lots are next: of all that are pending, the process that comes first by {!Process.first_by_velocity}. *)

val in_order : Model.t -> State.process -> (State.bond * State.lot) list
(** What is pending, by the places of the two ends. *)
