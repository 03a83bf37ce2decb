(** All states of a small model, as states of a document. *)

open Scc_calculus

(** The extent of an exploration. *)
type t = {
  states : int;  (** the number of states in the document *)
  expanded : int;  (** the number of states whose transitions are in the document *)
  complete : bool;  (** the document has every transition of each state, and its target *)
  bound : int;  (** the greatest number of states for this model *)
}

val expand : States.t -> States.world -> most:int -> int * State.t -> (int * State.t) list
(** Adds the transitions of a state, unless the document has them or the numbers of the state are
    {!States.too_long}, and returns the states that are new. No state is added beyond [most] states. *)

val reach : States.t -> States.world -> most:int -> int * State.t -> unit
(** Adds the transitions of a state and their targets, also those targets for which there was no room before. *)

val explore : States.t -> States.world -> most:int -> interrupted:(unit -> bool) -> State.t -> t
(** Adds states breadth first from the initial state, until all are known, [most] is reached, or [interrupted]
    is true. *)

val bound : Model.t -> int -> int
(** [bound m most] is the greatest number of states for a document: at most [most], and fewer if each state is
    large. *)
