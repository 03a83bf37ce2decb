(** Collisions of two processes (rule Collision), resolved by rule Bind or rule Bounce. *)

open Scc_exact
open Scc_geometry
open Scc_calculus

(** Two basic shapes of different processes that touch. *)
type touch = {
  one : int * int;  (** leaf and part *)
  two : int * int;
  obstacle : Obstacle.t;
  offset : Vec.t;  (** from the reference point of the first part to that of the second *)
  approaching : bool;
}

(** Two processes that touch, the one with the lesser index first. *)
type contact = { first : int; second : int;  (** indices of processes *) touches : touch list }

val contacts : Model.t -> State.t -> contact list
(** Every two processes in relative motion that touch, in order. *)

val colliding : contact -> bool
(** Some touching pair is approaching (rule Approach); grazing and resting are no collision. *)

type outcome = { label : Transition.label; rules : Rule.t list; results : State.process list }

val bind : Model.t -> State.t -> contact -> outcome list
(** Rule Bind: one outcome for each binding candidate (reading I-12) of a collision. *)

val bounce : Model.t -> State.t -> contact -> outcome
(** Rule Bounce: the elastic response of a collision (rule Response, reading I-13), which is what happens
    when there is no candidate. *)

val resolve : Model.t -> State.t -> contact -> outcome list
(** The outcomes of a collision: all of {!bind}, or {!bounce} if there are none. *)

val first_time_of_contact : Model.t -> State.t -> limit:Rat.t option -> Rat.t option
(** Rule Ftoc: the least t > 0 at which two processes collide, if there is one that is at most [limit];
    for a state in which none collide now. *)
