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

(** {1 Runs of a simulation} *)

(** A simulation that was made. *)
type simulation = {
  spread : Scc_view.Spread.t;  (** with all runs that may be shown *)
  limits : Scc_runs.Replay.limits;  (** of each run *)
  numbers : Scc_property.Property.num list;  (** to plot *)
}

val most_runs : int
(** The greatest number of runs that a page shows: 20. *)

val simulated :
  Loaded.t ->
  name:string ->
  simulation ->
  cut:(Scc_view.Spread.shown -> Scc_exact.Rat.t option) ->
  interrupted:(unit -> bool) ->
  (Scc_view.Document.t, Diag.t list) result
(** The document of a simulation. Each run of the spread is made again from its seed, up to 20 000 transitions,
    until the rows of the document have 16 MB or [interrupted] is true. The spread of the document has the runs
    that were made. [cut run] is how far a run is made that an interruption has ended. *)
