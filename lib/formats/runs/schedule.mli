(** Schedules: the choices that determine one run of a model. *)

open Scc_base
open Scc_exact
open Scc_json

(** The transition taken in a state: its number among the successors, from 0, and the text of its label. At least
    one of them is given, and all that is given must fit.

    If bonds may be released at any time, the label [time(d)] lets any time d pass up to the greatest one, which
    has a number (rule Time). If time may pass for ever, its number is the one after all others. *)
type choice = { index : int option; label : string option; at : Span.t }

(** A schedule as it is read. *)
type t = {
  model : string option;  (** the path of the model, as given when the schedule was made *)
  check : string option;  (** the property that the run is a witness for *)
  digest : string option;  (** the digest of its model, see {!Scc_loading.Origin.val-digest} *)
  parameters : (string * Rat.t) list;  (** with their values *)
  choices : choice list;
  offset : Rat.t option;
  (** the time that passes after the last choice, without an event, up to the instant of a witness *)
  offset_at : Span.t;
}

val versions : int list
(** The versions of the format that can be read. *)

val format : (int * t, (int -> Span.t) -> t) Json_format.t
(** The format of a schedule, which is written with its version. Reading makes a schedule of the places of its
    choices by their numbers; {!t.offset_at} is unknown. *)

val version : Scc_loading.Origin.t -> int
(** The version of the format: 2 if labels [time(d)] may be less than the greatest time, and 1 otherwise. Both
    can be read. *)

val made :
  ?model:string -> ?check:string -> Scc_loading.Origin.t -> (int * string) list -> offset:Rat.t option -> int * t
(** The schedule of these choices (number and label), with its version. *)

val to_string : int * t -> string
(** The file, with a choice on each line. *)

val read : Source.t -> (t, Diag.t) result
(** Reads a schedule, or a trace, each line of which contains a choice. Any other text is SC0801. *)
