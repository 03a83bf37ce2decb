(** The runs of a document. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_explain
open Scc_json

(** The check that a run illustrates. *)
type about = {
  formula : string;
  verdict : string;  (** ["holds"], ["violated"], … *)
  text : string;  (** the verdict in full *)
}

(** A transition of a document: its choice, the numbers of its label and of the state where it leads, and its
    rules. With [tail], it is only time that passes where nothing happens any more. *)
type taken = { choice : int option; label : int; target : int; rules : Rule.t list; tail : bool }

(** A transition that was taken. *)
type step = {
  choice : int option;  (** its number among the successors; [None] for a passing of time in part *)
  label : Transition.label;
  rules : Rule.t list;
  after : State.t;
}

val about_members : (about, unit) Json_format.members
(** The format of the members of a check. *)

(** What happens in a run. *)
type course = {
  start : int;  (** the number of the state *)
  steps : taken list;
  rest : Rat.t;  (** the time that passes after the last step *)
  finish : string;  (** as in a witness, or as a trace ends *)
  cycle : int option;  (** the step from which on the run repeats *)
  facts : string list;
  argument : Witness.argument option;
  ending : string list;  (** lines about the end *)
}

(** A run of a document. *)
type t = {
  name : string;
  check : about option;
  course : course option;  (** [None]: no single run shows the verdict of the check *)
  values : (string * Rat.t) list;  (** of the parameters that have ranges *)
  leaves : Bodies.t list option;  (** if they differ from those of the document *)
  sample : bool;  (** it starts in the drawing of regions *)
  contrast : int option;
  (** it does otherwise than the run of a check, which comes before it; so many steps at their beginning are the
      same *)
}

val format : (t, unit) Json_format.t
(** The format of a run. *)

val run : string -> about option -> course option -> t
(** A run of that name, without values and leaves of its own. *)

val none : name:string -> about -> t
(** A check whose verdict no single run shows. *)

val with_leaves : Tables.t -> of_document:Model.t -> Model.t -> t -> t
(** [with_leaves tables ~of_document own run] is the run of a model [own] that may have other leaves than the model
    of the document: leaves may depend on parameters. *)

val about : t -> about -> ending:string list -> t
(** [about run check ~ending] is the run for a check whose verdict no single run shows, from a start about which
    the verdict is. *)

val of_witness : States.t -> States.world -> most:int -> name:string -> about option -> Witness.t -> t
(** A run that is the witness of a check. Its states get their transitions, as by {!Graph.expand} with
    [most]. *)

val of_steps :
  ?until:Rat.t ->
  States.t ->
  States.world ->
  most:int ->
  name:string ->
  initial:State.t ->
  step list ->
  offset:Rat.t ->
  finish:string ->
  ending:string list ->
  t
(** A run that was made by choices, and ends [offset] after its last transition. Its states get their
    transitions, as by {!Graph.expand} with [most]. Where nothing happens any more, it is shown for {!a_while}, or
    up to the time [until]. *)

val a_while : Semantics.t -> over:Rat.t -> State.t -> Rat.t
(** [a_while semantics ~over state] is how long a run is shown after [state], in which nothing happens any
    more. The run has taken the time [over]. *)
