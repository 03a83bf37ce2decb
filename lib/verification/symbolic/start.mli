(** The starts of a network: the zone of its declared states for all values of its parameters. *)

open Scc_exact
open Scc_calculus
open Scc_state_sets

(** The reason why some starts are not well-formed (rule WellFormed), with values of the parameters for which
    it applies. *)
type fault = {
  at : (string * Rat.t) list;  (** of all parameters *)
  reason : reason;
}

and reason =
  | Interpenetrate of (int * int) * (int * int)  (** two parts, each by its leaf and its index in the leaf *)
  | Apart of State.finish * State.finish  (** features that are bound, or glued, do not touch *)

val known : Model.t -> State.t -> Uncertain.t
(** The places of a declared state of which everything is known, as constants. *)

val zones : Instant.context -> Uncertain.t -> initial:State.t -> keeps_time:bool -> (Zone.t list, fault) result
(** [zones c u ~initial ~keeps_time] are the zones of all starts, where [initial] is the initial state for some
    values. With [keeps_time], time is a coordinate. *)
