(** Proofs, in floats, that a turning plane keeps two flying solids apart for some time. *)

type t = {
  flight : Flight.t;
  n : float array;
  rate : float array;
  (** the direction from A to B at the delay s from the instant that the flight is moved to is n + s rate *)
  low : float array;
  (** after {!holds}: lower bounds on the three coefficients in Bernstein form, over 0 to s, of the gap along that
      direction, times its length. All positive: proved. *)
  work : float array;
}

val make : Flight.t -> t
(** A separation for the flight, with zero for the direction and its rate, which are to be set before use. *)

val acceleration : t -> float -> float
(** [acceleration p s] is a bound on the acceleration of the gap along the direction, times its length, until
    [s] later. The effect of the turning of the direction is not included. *)

val holds : t -> float -> bool
(** [holds p s] is true if it is proved that the interiors are disjoint from the current instant of the flight
    until [s] >= 0 later. False only means that this plane does not prove it. The bounds are left in [low]. *)
