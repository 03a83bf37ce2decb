(** Guesses of the values of a component, in plain floats. Nothing that is proved depends on them. *)

open Enclosure

type pace = {
  mutable sweeps : int;
  mutable rounds : int;
  mutable change : float;  (** the greatest one of the last pair of sweeps *)
  mutable moved : float;  (** the sum of its changes *)
  mutable ratio : float;  (** of the last two sums *)
  mutable steady : int;  (** for how many pairs of sweeps the ratio has been nearly the same *)
  mutable rate : float;  (** the ratio when it last was so *)
  mutable least : float;  (** of the changes of the first sweeps of all rounds *)
  mutable since : int;  (** the round of that *)
  mutable early : int;  (** the number of sweeps at which ends are tried before they are near *)
  stride : float;  (** of sweeps that evaluate *)
  mutable calm : float;  (** with a stride above 1: the least sum of changes so far *)
}

val pace : t -> pace
(** At the beginning. *)

val start : t -> part -> pace -> unit
(** Puts what is known below into the guess, or what is known above (which is finite), whatever changes less in
    some sweeps: where nearly all values are near 1, they would come from 0 in many. *)

val directly : t -> part -> bool
(** Policy iteration by elimination, in small components: whether floats came to its end. *)

val round : t -> part -> pace -> target:float -> float
(** One round of sweeps; the change of its first one. *)

val distance : pace -> float -> float
(** How far the limit seems to be after such a change. *)

val stalled : t -> part -> float -> bool
(** Floats do not get on when a sweep changes the last digits alone. *)

val circling : pace -> bool
(** Many rounds have brought nothing. *)

val least : t -> part -> float
(** The least guess. *)

val per_step : t -> part -> gap:float -> sweeps:int -> float
(** Puts expected numbers of steps into [steps], for a margin: how much farther from the guess an end may be for
    each step, if it is to be no farther than the gap. 0 when it takes more sweeps than allowed. *)
