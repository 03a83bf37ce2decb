(** Guesses of the values of a component, in plain floats. No proved result depends on them. *)

open Enclosure

type pace = {
  mutable sweeps : int;  (** the number of sweeps so far *)
  mutable rounds : int;  (** the number of rounds so far *)
  mutable change : float;  (** the greatest change in the last pair of sweeps *)
  mutable moved : float;  (** the sum of the changes in that pair *)
  mutable ratio : float;  (** the ratio of the last two such sums *)
  mutable steady : int;  (** for how many pairs of sweeps the ratio has been nearly constant *)
  mutable rate : float;  (** the ratio when it was last nearly constant *)
  mutable least : float;  (** the least change in the first sweep of a round *)
  mutable since : int;  (** the round of that *)
  mutable early : int;  (** the number of sweeps after which ends are tried before guesses are near the limit *)
  stride : float;  (** the factor of over-relaxation in {!Rounded.evaluate} *)
  mutable calm : float;  (** with a stride above 1: the least sum of changes so far *)
}

val pace : t -> pace
(** [pace t] is the pace of a component before its first sweep, with a stride of 1. *)

val start : t -> part -> pace -> unit
(** [start t part p] sets the guess to the lower bounds or to the upper ones (which are finite), then makes two
    sweeps. It takes the bounds that change less in them: values near 1 would take many sweeps from 0. *)

val directly : t -> part -> bool
(** [directly t part] improves the guess of a small component by policy iteration with {!Direct}. It is true if
    that converged in floats, and false at once for components of more than {!Direct.greatest} nodes. *)

val round : t -> part -> pace -> target:float -> float
(** [round t part p ~target] makes one round of sweeps: one that finds the best rows, then pairs of sweeps that
    evaluate these, until the limit seems to be near [target]. It returns the greatest change in its first sweep.
*)

val distance : pace -> float -> float
(** [distance p change] is how far the limit seems to be after a sweep with this greatest change; infinite while
    the changes do not shrink. *)

val stalled : t -> part -> float -> bool
(** [stalled t part change] is true if a sweep with this greatest change has changed only the last digits of
    floats. *)

val circling : pace -> bool
(** [circling p] is true if the first sweeps of more than 1 000 rounds have brought no change below the least one.
*)

val least : t -> part -> float
(** [least t part] is the least guess in the component. *)

val per_step : t -> part -> gap:float -> sweeps:int -> float
(** [per_step t part ~gap ~sweeps] puts guesses of the expected numbers of steps within the component into [steps].
    It returns the margin of an end per step, such that each end is within [gap] of its guess. It is 0 if the
    guesses take more than about [sweeps] sweeps. *)
