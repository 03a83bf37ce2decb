(** Where random networks of bodies that turn get to. *)

open Scc_calculus
open Scc_semantics

val bits : State.t -> int
(** How long the numbers of a state are. *)

val longest : int
(** Exact numbers grow quickly where nothing is rounded: states with longer ones are left alone. *)

val states : ?limit:int -> ?steps:int -> Model.t -> State.t -> (State.t * Transition.t list) list
(** The first [limit] states (8) breadth first from a state, and those of a run of [steps] transitions (16), each
    with its transitions; none for a persistent contact, nor for a state with numbers that are too long. *)

val reached : Random_rigid.t -> Model.t * (State.t * Transition.t list) list
(** {!states} from the initial one. *)
