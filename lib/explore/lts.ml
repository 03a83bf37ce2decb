(** What the explorer knows of a transition system: states are tuples of numbers of one width, and labels are
    numbers; what they stand for is known to the context, which gives numbers to things as they come up. *)

(** A transition, with what it changes of the state. *)
type step = { label : int; changes : Tuples.changes }

module type S = sig
  type context
  (** what stays the same (a model), and what the numbers stand for *)

  type fault
  (** why a state's transitions cannot be computed *)

  val width : context -> int
  val initial : context -> int array

  val successors : context -> int array -> (step list, fault) result
  (** Every transition, in a fixed order. Numbers are in [0, 2{^31}). *)

  val reduced : context -> int array -> step list option
  (** Some of the transitions of {!successors}, in the same order, that will do for what is asked as long as
      they lead to states that have not been seen yet: what else is possible is put off, and possible
      afterwards. [None]: no less than all will do. *)

  val longest : context -> int
  (** No number that came up is longer than so many bits. Answered at once. *)

  val bits : context -> int array -> int
  (** The bits of the longest number of a state; of interest only where {!longest} is too much. *)

  val duration : context -> int -> Scc_exact.Rat.t
  (** Of a label; 0 for a discrete transition. *)
end
