(** The states of a document. Each is stored as its changes since another state: the processes that are gone and
    those that have come. The others have moved on for the time in between. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_json

(** The states of a document, numbered from 0. *)
type t

val create : unit -> t
(** No states. *)

(** {1 States of one model} *)

type world
(** The rules of a model with values for its parameters, and the numbers of its states. *)

val world :
  ?bits:int ->
  t ->
  Tables.t ->
  words:(Model.t -> Transition.label -> string) ->
  plots:Property.num list ->
  Semantics.t ->
  world
(** [world t tables ~words ~plots semantics] adds its states to [t]. [words] describes a label in plain
    language, and [plots] are the numbers that are plotted. Numbers of more than [bits] are too long to go on with:
    see {!too_long}. *)

val semantics : world -> Semantics.t
(** The semantics of the model. *)

val too_long : world -> State.t -> bool
(** [too_long w state] is true if a number of the state has more bits than [w] goes on with: what follows could
    take for ever. *)

val start : world -> State.t -> int
(** The number of a state that is stored in full, unless it is known. *)

val after : world -> int * State.t -> Rat.t -> State.t -> int
(** [after w (before, state) d next] is the number of the state [next], which [state] with the number [before]
    reaches in the time [d]. It is added if it is not known. *)

val changes : Model.t -> Rat.t -> State.t -> State.t -> int list * State.process list
(** [changes m d before after] is what {!changed} takes, if [before] becomes [after] in the time [d]: the first
    leaves of the processes that are gone, and the processes that have come. *)

val changed : world -> int -> Rat.t -> gone:int list -> come:State.process list -> State.t Lazy.t -> int
(** [changed w before d ~gone ~come state] is the number of a new state, by its changes since the state [before]
    in the time [d]. It is not entered for {!known}. *)

val known : world -> State.t -> int option
(** The number of a state that {!start} or {!after} has added. *)

val label : world -> Transition.label -> int
(** The number of a label in the tables. *)

val set_extent : world -> int -> State.t -> Scc_ctl.Timeline.extent -> unit
(** [set_extent w n state extent] adds the numbers to be plotted from state [n] on, while nothing happens,
    unless it has some. *)

val set_values : world -> int -> (unit -> Scc_runs.Curve_json.t list) -> unit
(** Adds these numbers, one for each of {!plots}, unless the state has some. *)

val plots : world -> Property.num list
(** The numbers that are plotted. *)

(** {1 What is possible there} *)

(** A transition. *)
type possible = {
  label : int;
  rules : Rule.t list;
  target : int option;  (** if the document has it *)
  chance : Rat.t option;  (** its probability, if chance decides *)
}

val set_next : t -> int -> possible list -> unit
(** Sets the transitions of a state. *)

val has_next : t -> int -> bool
(** [has_next t n] is true if the transitions of state [n] are set. *)

val next : t -> int -> possible list option
(** The transitions of a state, if they are set. *)

val told : t -> int -> bool
(** [told t n] is true if the document has the transitions of state [n] and all their targets. *)

val home : t -> int -> world * State.t
(** [home t n] is the state [n] itself, with its world. *)

val set_stuck : t -> int -> string -> unit
(** Marks a state as stuck, with the reason why its transitions cannot be computed. *)

val set_rests : t -> int -> unit
(** Marks a state after which nothing happens and time passes for ever. *)

val rest : world -> int -> unit
(** [rest w n] is {!set_rests} of a state that has no transitions. *)

val count : t -> int
(** The number of states. *)

val all_told : t -> bool
(** [all_told t] is true if {!told} is true for each state. *)

type entry
(** A state of a document. *)

val format : (entry, unit) Json_format.t
(** The format of a state. *)

val json : t -> int -> Json.t
(** A state as an object. *)

val write : t -> (string -> unit) -> unit
(** Writes all states as an array. *)

val rules : (Rule.t list, string list) Json_format.t
(** The format of the names of rules. *)
