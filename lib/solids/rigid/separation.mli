(** Proofs, in floats, that a plane that turns keeps two flying solids apart for a while. *)

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

val acceleration : t -> float -> float
(** At most this much the gap accelerates along the direction, times its length, anywhere until s later, beyond
    what the turning of the direction does. *)

val holds : t -> float -> bool
(** [holds p s]: the interiors are disjoint from the instant that the flight is moved to, until s >= 0 later. False
    only means that this plane does not prove it. *)
