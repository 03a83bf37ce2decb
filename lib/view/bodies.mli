(** What of a model never changes: its solids and its leaves. *)

open Scc_calculus
open Scc_exchange

val leaves : solids:Rows.t -> Model.t -> Json.t
(** The leaves with their parts, in order; their solids become rows. *)
