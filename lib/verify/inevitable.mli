(** Whether a goal is met on every run (AF), on an abstract timed graph: the search for a run that avoids
    it. No fairness is assumed, and time need not diverge for a run to count, but a run that goes round
    for ever within one instant (Zeno) is told apart. *)

open Scc_exact

(** A transition, or a time transition with the first moment strictly inside it at which the goal holds. *)
type arc = { target : int; duration : Rat.t; first : Timeline.moment option }

type node =
  | Unexplored  (** what follows is not known *)
  | Arcs of arc array  (** not empty *)
  | Ray of Timeline.moment option  (** time passes for ever; the first moment at which the goal holds *)
  | Dead_end  (** the run stops *)

(** Node 0 is the initial one; [holds] is the goal at the nodes themselves. *)
type graph = { size : int; holds : int -> bool; node : int -> node }

(** Where a run that avoids the goal leads, after the steps of its path. *)
type finish =
  | Rests  (** the ray of the last node *)
  | Stops  (** a dead end *)
  | Repeats of int  (** back to the node before the step of this index, for ever *)
  | Passes of int option
  (** the bound of time is passed in the middle of this choice, or of the ray *)

type trace = { steps : (int * int) list;  (** node and index of the arc taken *) last : int; finish : finish }

type outcome = {
  avoided : trace option;  (** a run that avoids the goal (within the bound) *)
  zeno : trace option;  (** a run that avoids it and goes round within one instant *)
  unexplored : int list;  (** nodes of avoiding runs at which knowledge ends *)
}

val search : graph -> within:Rat.t option -> outcome
(** With [within = Some b], the goal must hold at some instant in [0, b]. The goal is inevitable when all
    three are empty; [zeno] and [unexplored] are only looked for when nothing avoids it. *)
