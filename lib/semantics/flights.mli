(** Where the processes of an inertial network go, as straight lines, and which of them will collide.

    The line of a process is the process with its positions put back to where they were, or would have been, at
    time 0: position = line + velocity * time. Lines change with the velocity only, and their numbers are
    shorter than those of positions. Times are absolute and at least 0.

    Each part of a process is kept in a tree of boxes, by what it sweeps until it will have moved by about its
    size. Collisions during the sweeps of both processes are known; for later ones a sweep is renewed. *)

open Scc_exact
open Scc_calculus

type t

(** One process on its way. *)
type flight = private {
  first : int;  (** its first leaf *)
  velocity : Vec.t;
  parts : int array;
  mutable sweep : int;  (** the number of its present sweep; -1 once it has been dropped *)
  mutable until : Rat.t option;  (** when the sweep ends; [None]: never *)
  mutable bound : float;  (** at least that *)
  mutable rounds : int;  (** sweeps before this one *)
}

type contact = Rat.t -> flight -> flight -> unit
(** Two processes will collide at a time, if both keep to their present sweeps until then. *)

val create : Model.t -> t

val launch : t -> now:Rat.t -> State.process -> contact -> flight
(** [launch t ~now line found] adds a process, sweeps it from [now] on and tells its collisions with all those
    launched before: for each other process the time of the first collision, if it is during both sweeps. *)

val renew : t -> now:Rat.t -> flight -> contact -> unit
(** Sweeps it from [now] on anew, further than before. *)

val drop : t -> flight -> unit
(** Removes it. *)

(** What has been done so far; for measurements. *)
type work = {
  sweeps : int;
  neighbours : int;  (** what sweeps found in the tree, themselves among it *)
  casts : int;  (** exact queries *)
}

val work : t -> work
