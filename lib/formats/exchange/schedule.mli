(** Schedules: the choices that lead a model through one run. *)

open Scc_base
open Scc_exact

(** The transition taken in a state: its number among the successors, from 0, and its label's text. At least
    one of them is given; what is given must fit. Where bonds may be released at any time, the label [time(d)] lets
    any time d pass up to the greatest one, which is the one that has a number (rule Time); where time may pass for
    ever, its number is the one after all others. *)
type choice = { index : int option; label : string option; at : Span.t }

type t = {
  model : string option;  (** the path of the model, as it was given when the schedule was made *)
  check : string option;  (** the property that the run is a witness for *)
  digest : string option;  (** of the model it was made for, see {!Scc_session.Origin.digest} *)
  parameters : (string * Rat.t) list;  (** with their values *)
  choices : choice list;
  offset : Rat.t option;
  (** time that passes after the last choice, without an event: the instant that a witness is about *)
  offset_at : Span.t;
}

val version : Scc_session.Origin.t -> int
(** Of the format: 2 where labels [time(d)] may be less than the greatest time, else 1. Both can be read. *)

val to_string :
  ?model:string ->
  ?check:string ->
  Scc_session.Origin.t ->
  (int * string) list ->
  offset:Rat.t option ->
  string
(** The file for the choices (number and label), one a line. *)

val read : Source.t -> (t, Diag.t) result
(** Reads a schedule, or the schedule of a trace, which each of its lines holds (SC0801 otherwise). *)
