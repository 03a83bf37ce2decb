(** All that can happen in a small model, as states of a document. *)

open Scc_calculus

type t = {
  states : int;  (** that are told *)
  expanded : int;  (** of them, those of which all transitions are told *)
  complete : bool;  (** every transition of each is told, and leads to a state that is *)
  bound : int;  (** the most states that would have been told *)
}

val expand : States.t -> States.world -> most:int -> int * State.t -> (int * State.t) list
(** Tells what is possible in a state, if that is not told yet: the states that were not known before are the
    result. Where [most] states are told already, others are not. *)

val reach : States.t -> States.world -> most:int -> int * State.t -> unit
(** Tells what is possible in a state and where it leads, also where that was not told before for want of space. *)

val explore : States.t -> States.world -> most:int -> interrupted:(unit -> bool) -> State.t -> t
(** Breadth first from the initial state. *)

val bound : Model.t -> int -> int
(** How many states to tell of a model at most, when that many are asked for: fewer where each is large. *)
