(** [scc view --svg]: a picture of one state. *)

open Scc_base
open Scc_exact
open Scc_calculus

val state : Console.t -> Viewed.options -> Watch.t -> Rat.t -> (Model.t * State.t, Diag.t list) result
(** The state at a time: of the run of a schedule, of that which shows the verdict of a check, or of that of the
    first choices. Of several states of one instant the last. SC0208 when the run is over before. *)
