(** Where a network may start: the zone of its declared states for all values of its parameters. *)

open Scc_exact
open Scc_calculus

(** Why some of the starts are none (rule WellFormed), with values of the parameters for which it is so. *)
type fault = {
  at : (string * Rat.t) list;  (** of all parameters *)
  reason : reason;
}

and reason =
  | Interpenetrate of (int * int) * (int * int)  (** two parts: their leaves, and which ones they are of those *)
  | Apart of State.finish * State.finish  (** features that are bound, or glued, do not touch *)

val known : Model.t -> State.t -> Uncertain.t
(** Of a declared state of which everything is known. *)

val zones : Instant.context -> Uncertain.t -> initial:State.t -> keeps_time:bool -> (Zone.t list, fault) result
(** [initial] is the initial state for one of the values. *)
