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

(** {1 What is due} *)

val followed : Model.t -> State.process -> State.bond -> State.drawn -> State.finish -> Process.released list list
(** The ways in which an end of a bond may let go: by what it has drawn or chosen, or, where it is free, by any of
    its summands without a chance. Summands of which the same comes are one way. *)

(** A bond that is released now, and what its ends have drawn or chosen. *)
type to_release = { bond : State.bond; drawn : State.drawn }

(** What comes next while lots are pending. Each of the first three is of one process and one bond at a time, in
    the order of {!Process.first_by_velocity} and of places, and none comes before those above it have come for the
    whole network. *)
type due =
  | To_draw of State.process * State.bond  (** the lot of this bond is drawn *)
  | To_be_first of State.process * State.bond list
  (** one of these, which hang together by leaves that they share, is drawn to be released before the others *)
  | To_choose of State.process * to_release  (** this bond may be released in several ways, and so may others *)
  | To_release of (State.process * to_release list) list
  (** all of these are released at once; one of them at most may be in several ways *)

val due : Model.t -> State.t -> due option
(** [None] where no lots are pending. *)

val some_undecided : State.process -> bool
(** Whether a bond of it is still to draw. *)

val clusters : (State.bond * State.lot) list -> (State.bond * State.lot) list list
(** Those that hang together by leaves that they share. *)
