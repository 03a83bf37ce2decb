(** A short text of the states of a graph for readers: all that differs between its states, except positions. *)

open Scc_calculus

(** The states of a graph, and what they have in common. *)
type t

val make : positions:bool -> Model.t -> size:int -> (int -> State.t) -> t
(** [make ~positions model ~size state] compares the states [state 0] to [state (size - 1)]. With [positions],
    digests include the positions and velocities of bodies that are not fixed. *)

val lines : t -> int -> string list
(** The digest of a state: the bonds that not every state has, the behaviours that differ between states, and
    the leaves that are gone. A behaviour that has aged since it became K is [K*]; other texts are cut after 40
    bytes. *)
