(** An explored graph as a Markov decision process: each transition is an action that leads to its target with
    probability 1, but for the draws of a state (rule Draw), which are one action together. A state in which
    nothing happens gets a loop, since every state of an MDP has an action: [rest] where time passes for ever,
    [stuck] where not even time passes, and [unexplored] where it is not known what happens. *)

open Scc_exact

type choice = {
  action : string;  (** see {!Safe_names} *)
  duration : Rat.t;  (** 0 for what takes no time, and for the loops *)
  targets : (int * Rat.t) list;  (** each once, in order, with its probability: positive ones that sum to 1 *)
}

type t

val make : Labelling.t -> t

val labelling : t -> Labelling.t

val states : t -> int
(** States and stretches (see {!Labelling}), numbered from 0, the initial state. *)

val count : t -> int
(** Of all choices. *)

val transitions : t -> int
(** Of all targets of all choices. *)

val choices : t -> int -> choice list
(** Not empty. *)

val labels : t -> int -> string list
(** The names of what holds there: those of {!State_predicates.reserved} first. *)

val label_names : t -> string list
(** Every label, in the order of {!labels}, held anywhere or not. *)

val occurs : t -> string -> bool
(** [occurs m] looks at every state once, and then tells which labels hold somewhere. *)

val actions : t -> (string * string) list
(** Each action with the text of the transition's label. *)
