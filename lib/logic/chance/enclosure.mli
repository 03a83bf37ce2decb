(** The state of an interval computation, on which {!Guess} and {!Interval_solver} work, and the test for its end.
*)

exception Enough
(** The computation ends: it is interrupted, or the intervals are good enough. *)

type t = {
  e : Equations.t;
  effort : Effort.t;
  r : Rounded.t;
  asked : int array;  (** the nodes whose values are wanted *)
  near_width : float;  (** a little less than the wanted width *)
  direct : Direct.t;
  mutable steps : Rounded.t option;
  (** Expected numbers of steps in the component that is worked on ({!Rounded.steps}), 0 elsewhere; made when they
      are first used. *)
  proper : bool;  (** every scheduler leaves each component almost surely *)
  few : bool;  (** at most 16 nodes are wanted, so that testing all of them costs nothing *)
  mutable fresh : bool;  (** this is the first pass, in which guesses are no better than bounds *)
  mutable work : int;  (** the number of visits of nodes *)
  mutable next : int;  (** the value of [work] at which the next test for the end is due *)
}

val start : Equations.t -> Effort.t -> upper:float -> asked:int array -> t
(** [start e effort ~upper ~asked] is the state before any work: all values are from 0 to [upper], which may be
    infinite. [asked] is the nodes whose values are wanted. *)

val good : t -> int -> bool
(** [good t v] is true if the interval of node [v] is narrow enough, or decides the bound of the effort. The test
    is exact. *)

val worked : t -> int -> unit
(** [worked t n] counts [n] more visits of nodes. Every 100 000 visits it raises {!Enough} if the computation is
    interrupted, or if [few] nodes are wanted and all are {!good}. *)

type part = { first : int; last : int }
(** The nodes of a component, from [first] to [last]. *)

val size : part -> int
(** [size part] is the number of its nodes. *)
