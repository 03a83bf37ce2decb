(** Models with schedules. *)

open Scc_base
open Scc_loading
open Scc_runs

val read : Console.t -> string -> (Schedule.t, Diag.t list) result
(** Reads the schedule in a file, and adds its text to the console. *)

val model :
  Console.t -> Schedule.t -> given:Options.definitions -> string -> (Loaded.t, Diag.t list) result
(** The model at a path with the parameters of the schedule and the given ones. These may repeat parameters of
    the schedule but not change them. A schedule for another text is SC0801. *)

val of_run : Loaded.t -> string -> ?check:string -> Scc_explain.Witness.t -> int * Schedule.t
(** [of_run l path ~check w] is the schedule of a run, with the name of the property that it is about, and the path
    of the model, unless that is standard input. *)

val of_witness :
  Loaded.t -> string -> Scc_property.Property.check -> Scc_explain.Witness.t -> int * Schedule.t
(** [of_witness loaded path check witness] is {!of_run} for the witness of a property. *)
