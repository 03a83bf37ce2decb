(** Guesses for a plane between two flying solids: its direction, and the time that it may last. They come from
    the features that are nearest at an instant. *)

val aim : Separation.t -> Gjk.t -> unit
(** After a search that found them apart, sets the direction to that of the search. The rate is such that the
    direction turns with the features of the corners. *)

(** Delays until the gap of these features closes, within the bound on the acceleration. *)
type delays = {
  sooner : float;  (** the gap is not closed before; infinite when it does not close *)
  later : float;  (** the gap is closed by then, if not much else changes; infinite when it does not close *)
}

val delays : Separation.t -> Gjk.t -> delays
(** The delays for the direction of the separation and the nearest features that the search has found. *)

val fitted : Separation.t -> float -> float
(** [fitted p s], after a proof that failed for the delay [s], is a shorter delay that is likely to be
    proved. *)
