(** A recorded trace compared with the states and labels of a model. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics

(** A model with a tolerance. *)
type t

val make : Semantics.t -> tolerance:Rat.t -> t
(** A model with a tolerance. Numbers agree if they differ by at most the tolerance; with 0, if they are
    equal. *)

val semantics : t -> Semantics.t
(** The semantics of the model. *)

val model : t -> Model.t
(** The model. *)

val tolerance : t -> Rat.t
(** The greatest difference of numbers that agree. *)

val leaf : t -> string -> int option
(** The leaf with this name. *)

val names : t -> Recorded.t -> Diag.t list
(** Errors (SC0804) for bodies and features that the model does not have, at most 20 of them. *)

(** {1 Events} *)

val matches : t -> State.t -> Recorded.event -> Transition.label -> bool
(** [matches t s e label] is true if the recorded event [e] can be the transition [label] of the state [s]. *)

(** How near a label of a state is to an event. *)
type nearness =
  | Same
  | Other_motion  (** of the same draw *)
  | Other_features  (** of the same kind, channel and bodies *)
  | Other_channel  (** of the same kind and bodies *)
  | Other_kind  (** of the same bodies *)
  | Other_partner  (** of the same kind, with a body in common *)
  | Unlike

val nearness : t -> State.t -> Recorded.event -> Transition.label -> nearness
(** [nearness t s e label] compares the recorded event [e] with the transition [label] of the state [s]. *)

val processes_of : t -> State.t -> Recorded.event -> int list
(** The processes of the bodies of an event, by their first leaves, sorted. *)

(** {1 States} *)

(** A difference between a recorded body and the state. *)
type difference = {
  body : string;
  quantity : string;  (** ["x"], ["vy"], ["behaviour"], ["bonds"], ["process"], ["clock"], ["turned"], ["step"] *)
  told : string;
  held : string;
  off : Rat.t option;  (** for numbers, [told] less [held] *)
}

(** The greatest differences of numbers that agree. *)
type deviation = { time : Rat.t; position : Rat.t; velocity : Rat.t }

val no_deviation : deviation
(** All differences are 0. *)

val later : deviation -> deviation -> deviation
(** The greater of each difference. *)

val body : t -> State.t -> Recorded.body -> difference list * deviation
(** The differences between a recorded body and the state. A body that the model does not have has none. *)

val differences : t -> State.t -> Recorded.body list -> Recorded.step option -> difference list * deviation
(** The differences of recorded bodies and of the movement step, in the order of the trace. *)
