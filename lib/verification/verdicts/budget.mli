(** The bounds of an exploration: those that were given, and defaults for the others. *)

open Scc_exact
open Scc_verify

type t = {
  depth : int option;  (** transitions *)
  time : Rat.t option;  (** model time *)
  states : int option;
  seconds : float option;  (** of the clock *)
  memory : int option;  (** words *)
  bits : int option;  (** of a number *)
}

type defaults = {
  states : int;
  memory : int;  (** words of the heap *)
  room : int option;  (** as {!Bounds.t} has it *)
}

val bounds : defaults -> t -> Bounds.t
(** [bounds defaults t] has the bounds of [t] as {!Bounds.Given}. States and memory, if they are not given,
    have bounds by default. *)
