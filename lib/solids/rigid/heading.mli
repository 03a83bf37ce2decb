(** Which way to look for a plane between two flying solids, and until when to hope for one: guesses, from the
    features that are nearest at an instant. *)

val aim : Separation.t -> Simplex.t -> unit
(** After a search that found them apart: the direction is that of the search, and its rate is such that it turns
    with the features of the corners. *)

(** As the gap of these features closes, within the bound on the acceleration. *)
type delays = {
  sooner : float;  (** the gap is not closed before; infinite when it does not close *)
  later : float;  (** the gap is closed by then, if not much else changes; infinite likewise *)
}

val delays : Separation.t -> Simplex.t -> delays

val first_root : float -> float -> float -> float
(** [first_root a b c]: the least t > 0 at which a + b t + c t^2 = 0, for a > 0; infinite if there is none. *)

val fitted : Separation.t -> float -> float
(** After a proof that failed for a delay s: a shorter delay that is likely to do. *)
