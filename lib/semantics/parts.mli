(** The basic shapes of a state laid out for the search of neighbours (the broad phase). *)

open Scc_exact
open Scc_calculus

type part = private {
  process : int;  (** index of its process in the state *)
  leaf : int;
  part : int;
  position : Vec.t;  (** of its reference point *)
  velocity : Vec.t;
  shape : Scc_geometry.Float_box.t;  (** about its reference point *)
}

val of_state : Model.t -> State.t -> part array
(** In the order of processes, leaves and parts. *)

val box : part -> Scc_geometry.Float_box.t
(** Contains the part where it is. *)

val near : part array -> (int * int) list
(** The pairs (lesser index first) of parts of processes in relative motion whose boxes, rounded outward, meet:
    all that touch are among them. Sorted. *)

val near_within : part array -> Rat.t -> (int * int) list
(** The pairs of processes in relative motion whose boxes, swept over [0, t] for a t > 0 and rounded outward,
    meet: all that touch meanwhile are among them. Sorted. *)

val fold_pairs : ('a -> int * int -> 'a) -> 'a -> part array -> 'a
(** Over every pair of parts (lesser index first) of processes in relative motion, in order. *)

val all_move_alike : part array -> bool
(** No two processes are in relative motion. *)

val first_window : part array -> limit:Rat.t option -> Rat.t option
(** How far ahead to look first: so far that the fastest part sweeps about the least size of a part, or to
    the limit if that is sooner. [None]: at everything, when there are few parts. *)

val wider : part array -> limit:Rat.t option -> met:int -> round:int -> Rat.t -> Rat.t option
(** The next window after one in which nothing was found, the [round]th from 1: four times as long, cut at
    the limit; [None] when the sweeps of the last one met so often ([met] pairs) that boxes no longer help,
    or when so many windows without a limit were looked at that perhaps nothing ever meets. *)
