(** What a recorded trace tells, against the states and labels of a model. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics

type t

val make : Semantics.t -> tolerance:Rat.t -> t
(** Numbers agree when they differ by at most the tolerance; with 0, when they are equal. *)

val semantics : t -> Semantics.t
val model : t -> Model.t
val tolerance : t -> Rat.t

val leaf : t -> string -> int option
(** By its name. *)

val names : t -> Recorded.t -> Diag.t list
(** SC0804 for bodies and features that the model does not have, up to twenty of them. *)

(** {1 Events} *)

val leaves : t -> Recorded.event -> int list
(** Of the bodies that it names, by its features too. *)

val matches : t -> State.t -> Recorded.event -> Transition.label -> bool
(** Whether it can be this transition of this state. *)

(** How near a label of a state is to an event. *)
type nearness =
  | Same
  | Other_velocity  (** drawn *)
  | Other_features  (** of the same kind, channel and bodies *)
  | Other_channel  (** of the same kind and bodies *)
  | Other_kind  (** of the same bodies *)
  | Other_partner  (** of the same kind, with a body in common *)
  | Unlike

val nearness : t -> State.t -> Recorded.event -> Transition.label -> nearness

val processes_of : t -> State.t -> Recorded.event -> int list
(** The processes of its bodies, by their first leaves, sorted. *)

(** {1 States} *)

(** What differs between a recorded body and the state. *)
type difference = {
  body : string;
  quantity : string;  (** ["x"], ["vy"], ["behaviour"], ["bonds"], ["process"], ["clock"], ["turned"], ["step"] *)
  told : string;
  held : string;
  off : Rat.t option;  (** told less held, of numbers *)
}

(** By how much the numbers that agree differ at most. *)
type deviation = { time : Rat.t; position : Rat.t; velocity : Rat.t }

val no_deviation : deviation
val later : deviation -> deviation -> deviation
(** The greater of each. *)

val body : t -> State.t -> Recorded.body -> difference list * deviation
(** Of one body; nothing of one that the model does not have. *)

val differences : t -> State.t -> Recorded.body list -> Recorded.step option -> difference list * deviation
(** In the order in which they are told. *)
