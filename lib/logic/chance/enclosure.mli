(** What is known of the values while they are enclosed, and whether it is enough: what {!Guess} and
    {!Interval_solver} work on. *)

exception Enough

type t = {
  e : Equations.t;
  effort : Effort.t;
  r : Rounded.t;
  asked : int array;  (** nodes *)
  near_width : float;  (** a little less than the width asked for *)
  direct : Direct.t;
  mutable steps : Rounded.t option;
  (** Expected numbers of steps in the component that is worked on ({!Rounded.steps}), 0 elsewhere; made when they
      are first used. *)
  proper : bool;  (** whether every scheduler leaves each component almost surely *)
  few : bool;  (** so few are asked for that to look at them costs nothing *)
  mutable fresh : bool;  (** whether this is the first pass, and guesses are no better than bounds *)
  mutable work : int;  (** nodes that were looked at *)
  mutable next : int;  (** the work at which the next question is due whether to go on *)
}

val start : Equations.t -> Effort.t -> upper:float -> asked:int array -> t

val good : t -> int -> bool
(** Whether the interval of a node is good enough, exactly. *)

val worked : t -> int -> unit
(** So many nodes were looked at. Raises {!Enough} when it is interrupted, or few are asked for and all are good.
*)

type part = { first : int; last : int }
(** The nodes of a component. *)

val size : part -> int
