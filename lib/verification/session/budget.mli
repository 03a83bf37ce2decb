(** What an exploration may take: what was asked for, and what it gets where nothing was. *)

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
(** What was asked for is {!Bounds.Given}; of the rest, states and memory are bounded by default. *)
