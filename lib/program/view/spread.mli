(** The values of all runs of a simulation at its times, for the page of [scc simulate --view]: how they are
    distributed, and those of the runs that the page shows. *)

open Scc_exact
open Scc_json

(** A run of the simulation that the document shows. *)
type shown = {
  number : int;  (** in the simulation *)
  values : Rat.t option array array;  (** by time, and then by observable *)
  ended : string option;  (** why it did not come to the last time *)
}

(** The values of an observable at a time. *)
type cell = {
  sorted : Rat.t array;  (** from the least to the greatest *)
  mean : Rat.t option;  (** [None] without a value *)
}

(** A simulation. Run [k] of the document is run [k] of [shown]. *)
type t = {
  seed : int64;  (** of all runs together *)
  first : int;  (** the number of the first run *)
  asked : int;  (** how many runs were to be made *)
  made : int;  (** how many runs have values in [cells] *)
  observables : string list;
  times : Rat.t array;
  over : int array;  (** by time: how many runs had ended before it *)
  cut : int array;  (** by time: how many runs an interruption had ended before it *)
  cells : cell array array;  (** by time, and then by observable *)
  shown : shown list;
  hurried : bool;  (** there are no more in [shown] since an interruption left no time for them *)
}

val most_cells : int
(** A page has room for so many times of so many observables together: 10 000. *)

(** {1 JSON} *)

val format : (t, unit) Json_format.t
(** The format of the values of a simulation. *)
