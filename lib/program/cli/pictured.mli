(** [scc view --svg]: a picture of one state. *)

open Scc_base
open Scc_exact
open Scc_calculus

val state :
  Console.t ->
  Viewed.options ->
  Watch.t ->
  Rat.t ->
  (Scc_elaborate.Repeated.t * Model.t * State.t, Diag.t list) result
(** The families of the model, the model, and its state at a time of a run. The run is that of a schedule, that
    of the witness of a check, or that of the first choices. If several states have this time, it is the last of
    them. A run that is over before is SC0208. *)
