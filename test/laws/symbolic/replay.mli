(** Runs to zones, followed by the ordinary rules; and whether what they lead to is in a zone. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_state_sets
open Scc_symbolic

val follow : Semantics.t -> State.t -> Concrete.t -> (State.t list, string) result
(** Where the ordinary rules lead from an initial state, in steps of these times and labels; or why they do not. *)

val is_in : Model.t -> Zone.t -> Rat.t array -> State.t -> bool
(** Whether the zone, of this model with its ranges, has this state, for these values of the parameters. *)
