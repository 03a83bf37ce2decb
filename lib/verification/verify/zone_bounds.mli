(** Bounds on an exploration of zones, and what is told where one was met. *)

val default_depth : int
(** In transitions: there is always a bound on depth. *)

val given : 'a Bounds.bound -> 'a option
(** [None]: there is none. *)

val depth : Bounds.t -> Verdict.truncation

val states : Bounds.t -> Verdict.truncation
(** It is a bug if there is no bound on them. *)
