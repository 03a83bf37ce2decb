(** Where the processes of an inertial network go, as straight lines, and which of them will collide.

    The line of a process is the process with its positions put back to where they were, or would have been, at
    time 0: position = line + velocity * time. Lines change with the velocity only, and their numbers are
    shorter than those of positions. Times are absolute and at least 0.

    Each part of a process is kept in a tree of boxes, by what it sweeps until it will have moved by about its
    size. Collisions during the sweeps of both processes are known; for later ones a sweep is renewed. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

(** One process on its way. *)
type flight = private {
  first : int;  (** its first leaf *)
  velocity : Vec.t;
  parts : int array;
  mutable sweep : int;  (** the number of its present sweep; -1 once it has been dropped *)
  mutable rounds : int;  (** sweeps before this one *)
}

(** Who is told of what is to come. *)
type watch = {
  contact : Rat.t -> flight -> flight -> unit;
  (** two processes will collide at a time, if both keep to their present sweeps until then *)
  sweep_end : Rat.t -> flight -> unit;  (** a sweep ends, and is to be renewed then *)
}

val create : Semantics.t -> t

val launch : t -> now:Rat.t -> State.process -> watch -> flight
(** [launch t ~now line watch] adds a process, sweeps it from [now] on and tells the end of the sweep, if it
    has one, and its collisions with all those launched before: for two parts, one of each, the time of their
    first collision, if it is during both sweeps. *)

val renew : t -> now:Rat.t -> flight -> watch -> unit
(** Sweeps it from [now] on anew, further than before, and tells the same. *)

val drop : t -> flight -> unit
(** Removes it. *)

(** What has been done so far; for measurements. *)
type work = {
  sweeps : int;
  neighbours : int;  (** what sweeps found in the tree, themselves among it *)
  casts : int;  (** exact queries *)
}

val work : t -> work
