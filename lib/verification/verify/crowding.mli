(** Many states of few instants, and what they differ by. *)

open Scc_state_space

(** What has happened within an instant. *)
type what =
  | Events  (** several were possible at once *)
  | Weak_splits  (** each of them could be put off *)
  | Draws  (** at least three of them, one after the other *)

type t = {
  what : what;
  states : int;  (** so many states were found last *)
  instants : int;  (** and begin at so few instants *)
}

val find : Network_lts.context -> State_graph.t -> t option
(** [find context graph] is what the states that were found last differ by, if they are many at each instant. A
    bounded number of states is considered. *)
