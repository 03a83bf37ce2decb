(** The methods [evaluate] and [values]: formulas of the property language, at a state and along a path. *)

(** The resources of a request. *)
type bounds = {
  seconds : float;  (** of the request *)
  memory : int;  (** words of the heap of the whole program *)
  now : unit -> float;  (** a clock in seconds *)
}

val options : bounds -> Read.params -> Scc_verify.Setup.t
(** The options of an exploration, by the member [limits] and within the bounds. More [states] than the quota
    are refused. *)

val evaluate : (bounds * Models.store) Method.t
(** The method [evaluate]: the value of a formula at the end of a path, or the verdict on a temporal formula
    from there. *)

val values : Models.store Method.t
(** The method [values]: the values of a number or state predicate along a path, over time. *)
