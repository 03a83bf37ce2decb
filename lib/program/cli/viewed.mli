(** What [scc view] shows of a model. *)

open Scc_base
open Scc_session
open Scc_verify

type checks = All | Only of string  (** by its name *) | Unchecked

type options = {
  path : string;
  source : Source.t option;  (** what is there, if it is not to be read *)
  given : Options.definitions;
  budget : Budget.t;
  checks : checks;  (** what is checked *)
  schedule : string option;  (** the file of a schedule or a trace: then nothing is checked *)
  graph : int;  (** how many states of all that can happen to carry along, at most *)
  plots : string list;  (** numbers to plot, besides those that the checks name *)
}

val document : Console.t -> options -> Watch.t -> (Scc_view.Document.t, Diag.t list) result
(** What is done when the watch stops it is shown. *)

(** {1 Parts of it} *)

val read_schedule : Console.t -> options -> (Scc_exchange.Schedule.t option, Diag.t list) result

val model : Console.t -> options -> Scc_exchange.Schedule.t option -> (Loaded.t, Diag.t list) result
(** Warnings are reported. *)

val at_point : Loaded.t -> (Loaded.t, Diag.t list) result
(** At simple values of the parameters that have ranges. *)

val find_check :
  string -> Scc_property.Property.check list -> (Scc_property.Property.check list, Diag.t list) result

val report :
  Console.t ->
  options ->
  Loaded.t ->
  Scc_property.Property.check list ->
  Watch.t ->
  (Verdict.outcome list * Scc_regions.Where.t list, Diag.t list) result
(** The verdicts; and where they hold, of a model with ranges. *)
