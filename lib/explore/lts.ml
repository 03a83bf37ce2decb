(** What the explorer knows of a transition system: states, labels, durations. *)

module type S = sig
  type context
  (** what stays the same (a model) *)

  type state

  type transition

  type fault
  (** why a state's transitions cannot be computed *)

  val initial : context -> state
  val successors : context -> state -> (transition list, fault) result
  (** Every transition, in a fixed order. *)

  val target : transition -> state
  val duration : transition -> Scc_exact.Rat.t
  (** 0 for a discrete transition. *)

  val equal : state -> state -> bool
  val hash : state -> int
end
