(** The documents of [scc view]. *)

open Scc_base
open Scc_loading
open Scc_verdicts
open Scc_verify

(** The checks that are made. *)
type checks = All | Only of string  (** by its name *) | Unchecked

(** The options of a document. *)
type options = {
  path : string;
  source : Source.t option;  (** its content, if the file is not read *)
  read_file : Loaded.reader option;  (** how imports and meshes are read, if not from files *)
  given : Options.definitions;
  budget : Budget.t;
  checks : checks;  (** which checks are made *)
  schedule : string option;  (** the file of a schedule or a trace; nothing is checked then *)
  graph : int;  (** the greatest number of states in the exploration of the document *)
  plots : string list;  (** numbers to plot, beside those that the checks name *)
}

val document : Console.t -> options -> Watch.t -> (Scc_view.Document.t, Diag.t list) result
(** Makes a document. If the watch stops the work, the document has the results so far. *)

(** {1 Parts of it} *)

val read_schedule : Console.t -> options -> (Scc_runs.Schedule.t option, Diag.t list) result
(** Reads the schedule of the options, if there is one. *)

val model : Console.t -> options -> Scc_runs.Schedule.t option -> (Loaded.t, Diag.t list) result
(** Loads the model, with the parameters of the schedule. Warnings are reported. *)

val at_point : Loaded.t -> (Loaded.t, Diag.t list) result
(** The model at simple values of the parameters that have ranges. *)

val find_check :
  string -> Scc_property.Property.check list -> (Scc_property.Property.check list, Diag.t list) result
(** The checks with this name. An unknown name is SC0201. *)

val report :
  Console.t ->
  options ->
  Loaded.t ->
  Scc_property.Property.check list ->
  Watch.t ->
  ( Verdict.outcome list * ((string * Scc_regions.Where.t) list * (string * Scc_regions.Chances.t) list),
    Diag.t list )
    result
(** The verdicts and, for a model with ranges, the values for which checks hold, and probabilities as functions of
    the values ({!Drawn_checks.split}). *)
