(** The methods [evaluate] and [values]: formulas of the property language, at a state and along a path. *)

type bounds = {
  seconds : float;  (** of the request *)
  memory : int;  (** words of the heap of the whole program *)
  now : unit -> float;  (** a clock in seconds *)
}

val options : bounds -> Read.params -> Scc_verify.Check.options
(** Of an exploration: by the member [limits], within the bounds. *)

val evaluate : bounds -> Models.store -> Read.params -> Reply.t
val values : Models.store -> Read.params -> Reply.t
