(** The states of a document. Each is told by what has changed since another one: by who has gone and who has come,
    while time has passed by so much for the others. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_exchange

type t

val create : unit -> t

(** {1 States of one model} *)

type world
(** The rules over a model with values for its parameters, with a memory of the states that were told. *)

val world :
  t -> Tables.t -> words:(Model.t -> Transition.label -> string) -> plots:Property.num list -> Semantics.t -> world

val semantics : world -> Semantics.t

val start : world -> State.t -> int
(** The number of a state that is told in full, unless it is known. *)

val after : world -> int * State.t -> Rat.t -> State.t -> int
(** [after w (before, state) d next]: the number of a state that is reached from another one in a time d. *)

val changed : world -> int -> Rat.t -> gone:int list -> come:State.process list -> State.t Lazy.t -> int
(** A new state, by what has changed since the one of that number in so much time. It is not {!known}. *)

val known : world -> State.t -> int option

val label : world -> Transition.label -> int

val set_extent : world -> int -> State.t -> Scc_ctl.Timeline.extent -> unit
(** Tells the numbers that are plotted from the state of that number on, while nothing happens. *)

val set_values : world -> int -> Json.t list -> unit
(** Tells them as given, one for each of {!plots}. *)

val plots : world -> Property.num list

(** {1 What is possible there} *)

type possible = { label : int; rules : Rule.t list; target : int option  (** if it is told *) }

val set_next : t -> int -> possible list -> unit
val has_next : t -> int -> bool
val next : t -> int -> possible list option

val told : t -> int -> bool
(** What is possible is told of the state of that number, and where it leads. *)

val home : t -> int -> world * State.t
(** The state of that number, and where it is at home. *)

val set_stuck : t -> int -> string -> unit
val set_rests : t -> int -> unit
val count : t -> int

val all_told : t -> bool
(** {!told} of each of them. *)

val json : t -> int -> Json.t
(** One of them. *)

val write : t -> (string -> unit) -> unit
(** All of them, as an array. *)

val rules : Rule.t list -> Json.t
