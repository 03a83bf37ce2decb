(** Models that are run by a schedule. *)

open Scc_base
open Scc_session
open Scc_exchange

val read : Console.t -> string -> (Schedule.t, Diag.t list) result
(** The schedule in a file; its text becomes known to the console. *)

val model :
  Console.t -> Schedule.t -> given:Options.definitions -> string -> (Loaded.t, Diag.t list) result
(** The model at a path with the parameters of the schedule, which what is given may repeat but not change, and
    others that are given. SC0801 when the schedule was made for another text. *)

val of_witness :
  Loaded.t -> string -> Scc_property.Property.check -> Scc_explain.Witness.t -> string
(** The schedule of a run that shows something of a property, with the path of the model, unless that is standard
    input. *)
