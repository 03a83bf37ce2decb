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
  (** Every transition, in a fixed order. Numbers are at least 0 and below 2{^31}. *)

  val reduced : context -> int array -> step list option
  (** Some of the transitions of {!successors}, in the same order, that will do for what is asked as long as
      they lead to states that have not been seen yet: what else is possible is put off, and possible
      afterwards. [None]: no less than all will do. *)

  val entered : context -> Tuples.changes -> unit
  (** A state has been found that differs so from one that was found before; of the first, all of it. *)

  val longest : context -> int
  (** No number that came up is longer than so many bits. Answered at once. *)

  val bits : context -> int array -> int
  (** The bits of the longest number of a state; of interest only where {!longest} is too much. *)

  val duration : context -> int -> Scc_exact.Rat.t
  (** Of a label; 0 for a discrete transition. *)

  val transitions : context -> int -> int
  (** How many transitions of a run a label stands for, 1 or more. The depth of its target counts them all. *)

  (** {1 Processes that share a graph} *)

  val numbers_so_far : context -> int
  (** More than any number that has been given to a component or a label. *)

  val share : context -> Common.t -> bool
  (** From now on components and labels that come up have the same numbers in all processes that are forked
      afterwards; the table begins with {!numbers_so_far}, or later. It is false if the system gives no memory. *)

  val has_entered : context -> Tuples.changes -> bool
  (** The process that numbers the states has noted all that {!entered} would note. Any process may ask. *)
end

(** Part of a system that one process explores alone. *)
module Alone = struct
  let numbers_so_far _ = 0
  let share _ _ = false
  let has_entered _ _ = false
end

(** What the numbers of a system mean to another process: they are exchanged for bytes, which are the same for the
    same things in each of them. *)
module type Exchange = sig
  type context

  val width : context -> int
  (** Of the tuples. *)

  val families : context -> int
  val family : context -> int -> int
  (** Of a slot, below {!families}: slots of one family share their numbers. *)

  val component : context -> family:int -> int -> string
  val of_component : context -> family:int -> string -> int
  (** Raises [Failure], with what is wrong, for bytes that {!component} has not made for the same model; so does
      {!of_name}. *)

  val name : context -> int -> string
  (** Of a label. *)

  val of_name : context -> string -> int
end
