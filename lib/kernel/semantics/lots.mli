(** Which bonds lots are drawn for, and when (rule Lot). {!Splits.lots} has the outcomes of the lots. *)

open Scc_exact
open Scc_calculus

(** One end of a bond that lots are drawn for, with probabilities as numbers of {!Chances}. *)
type 'c side = {
  finish : State.finish;
  drawn : (Behaviour.t * 'c) list;
  (** its summands that release the bond by chance, each with its probability, more than 0; if there are none, the
      end chooses freely among its other summands *)
}

val sides : 'c Chances.t -> Model.t -> State.process -> State.bond -> ('c side * 'c side) option
(** The ends of a bond, the lesser one first, if lots are drawn for it. That is so if both ends would release it,
    and at least one of them by chance. *)

val wait : Model.t -> State.process -> Rat.t option
(** The time until the next split instant of the network, if lots would be drawn then for a bond of the process. *)

val start : Model.t -> State.process -> State.process
(** The process in the initial state: the time since the last split instant is 0, and no lots are pending. In
    models without lots it has none. *)

val pass : Model.t -> Rat.t -> State.process -> State.process
(** [pass m d p] is the lots of [p] after a time d > 0, at most {!wait}; the behaviours of [p] have aged already.
    At a split instant, all bonds that lots are drawn for become pending. *)

val piece : Model.t -> whole:State.process -> State.process -> State.process
(** [piece m ~whole p] is [p], a piece of [whole], with those lots of the whole that concern its bonds and that its
    leaves would still follow. An undecided lot is a bug: no bond is released before all lots are drawn. *)

val is_pending : State.process -> bool
(** [is_pending p] is true if a bond of [p] is to be drawn for or released at this instant. *)

val pending : State.t -> bool
(** [pending s] is true if {!is_pending} holds for a process of [s]. *)

(** {1 What is due} *)

val followed : Model.t -> State.process -> State.bond -> State.drawn -> State.finish -> Process.released list list
(** [followed m p b drawn f] is the ways in which the end [f] of bond [b] may release it. If [drawn] has a
    summand for [f], the only way is that of this summand. Else the ways are the summands without a chance.
    Summands with equal results are one way. *)

(** A bond that is released now, and what its ends have drawn or chosen. *)
type to_release = { bond : State.bond; drawn : State.drawn }

(** The next action while lots are pending. Each of the first three concerns one process and one decision at a
    time. Processes come in the order of {!Process.first_by_velocity}, bonds in the order of their places. All
    actions of one kind, in the whole network, come before those of the next kind. *)
type due =
  | To_draw of State.process * State.bond  (** the lot of this bond is drawn *)
  | To_be_first of State.process * State.bond list
  (** one of these bonds, which are connected by shared leaves, is drawn to be released before the others *)
  | To_choose of State.process * to_release  (** this bond may be released in several ways, and so may others *)
  | To_release of (State.process * to_release list) list
  (** all of these bonds are released at once; at most one of them has several ways *)

val due : Model.t -> State.t -> due option
(** The next action at this instant; [None] if no lots are pending. *)

(** {1 The same of one process} *)

val some_undecided : State.process -> bool
(** [some_undecided p] is true if the lot of a bond of [p] is still to be drawn. *)

val undecided : Model.t -> State.process -> State.bond list
(** The bonds of a process whose lots are still to be drawn, in order. *)

val some_contested : State.process -> bool
(** [some_contested p] is true if {!due} has a bond of [p] to be first, where all lots have been drawn. *)

val contested : Model.t -> State.process -> State.bond list
(** The first set of connected bonds of a process of which one is to be first; it is a bug if there is none
    ({!some_contested}). *)

val released_now : Model.t -> State.process -> to_release list
(** The bonds of a process that are released next, in order, once none of its lots is undecided or contested. *)

val several_ways : Model.t -> State.process -> to_release list
(** [several_ways m p] are those of {!released_now} of [p] that may be released in several ways. *)

val clusters : (State.bond * State.lot) list -> (State.bond * State.lot) list list
(** The connected sets of bonds under shared leaves. Each set keeps the given order, and the sets are in the
    order of their first bonds. *)
