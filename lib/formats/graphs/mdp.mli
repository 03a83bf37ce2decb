(** An explored graph as a Markov decision process. Each transition is an action that leads to its target with
    probability 1, except that what chance decides in a state is one action: its draws (rules Draw and Lot), or its
    urgent transitions in a model that draws ties (rule Ties), by the name [tie].

    Every state of an MDP needs an action, so a state without transitions gets a loop. It is [rest] if time
    passes for ever, [stuck] if not even time passes, and [unexplored] if its transitions are not known. *)

open Scc_exact

(** An action of a state. *)
type choice = {
  action : string;  (** its name, by {!Safe_names} *)
  duration : Rat.t;  (** model time; 0 for actions that take no time, and for the loops *)
  targets : (int * Rat.t) list;  (** each once, in order, with its probability: positive ones that sum to 1 *)
}

(** A Markov decision process. *)
type t

val make : Labelling.t -> t
(** The process of a labelled graph. Actions get their names in the order of the states. *)

val labelling : t -> Labelling.t
(** The labelled graph. *)

val states : t -> int
(** The number of states and stretches (see {!Labelling}), which are numbered from 0, the initial state. *)

val count : t -> int
(** The number of choices of all states. *)

val transitions : t -> int
(** The number of targets of all choices. *)

val choices : t -> int -> choice list
(** The choices of a state; not empty. *)

val labels : t -> int -> string list
(** The names of the labels that hold in a state: those of {!State_predicates.reserved} first. *)

val label_names : t -> string list
(** The names of all labels, in the order of {!labels}, whether or not they hold anywhere. *)

val occurs : t -> string -> bool
(** [occurs m] examines every state once, and returns a function that is true for the labels that hold
    somewhere. *)

val actions : t -> (string * string) list
(** The name of each action with the text of the label of its transition. *)
