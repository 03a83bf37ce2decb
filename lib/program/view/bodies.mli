(** What of a model never changes: its solids and its leaves. *)

open Scc_calculus
open Scc_exchange

val leaves : solids:Rows.t -> Model.t -> Json.t
(** The leaves with their parts, in order; their solids become rows. *)

val families : Model.t -> Json.t
(** The names of the families that leaves tell by their numbers ({!Scc_calculus.Families}). *)
