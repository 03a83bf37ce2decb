(** The courses of the processes of an inertial network, as straight lines, and the collisions to come.

    The line of a process is the process with its positions extrapolated back to time 0: position = line +
    velocity * time. A line changes with the velocity only, and its numbers are shorter than those of positions.
    Times count from the start of the run and are at least 0.

    A tree of boxes has each part of a process, by the box that it sweeps until it has moved by about twice its
    size. Collisions during the present sweeps of both processes are known. A sweep is renewed when it ends. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

(** One process on its way. *)
type flight = private {
  first : int;  (** its first leaf *)
  mutable velocity : Vec.t;
  parts : int array;
  mutable sweep : int;  (** the number of its present sweep; -1 once it has been dropped *)
  mutable rounds : int;  (** the number of sweeps before this one *)
}

(** The callbacks for what is to come. *)
type watch = {
  contact : Rat.t -> flight -> flight -> unit;
  (** called for two processes that will collide at this time, if both keep to their present sweeps until then *)
  sweep_end : Rat.t -> flight -> unit;  (** called for a sweep that ends at this time; it is to be renewed then *)
}

val create : Semantics.t -> t
(** An empty set of flights for the model of this semantics, whose geometry computes the casts. *)

val launch : t -> now:Rat.t -> turns:Rat.t option -> State.process -> watch -> flight
(** [launch t ~now ~turns line watch] adds the process with this line and sweeps it from [now] on, and not far
    beyond [turns], the time at which its velocity is likely to change. It calls [watch] for
    the end of the sweep, if it has one, and for collisions with all processes launched before. These are the
    first collisions of two parts, one of each process, during the sweeps of both. *)

val renew : t -> now:Rat.t -> turns:(flight -> Rat.t option) -> flight list -> watch -> unit
(** [renew t ~now ~turns flights watch] sweeps flights, which are in the tree, once more: from [now] on and over
    times farther than before. It calls [watch] as {!launch} does. *)

val turn :
  t -> now:Rat.t -> turns:(flight -> Rat.t option) -> (flight * State.process) list -> watch -> unit
(** [turn t ~now ~turns flights watch] gives each flight the line beside it, which is of the same leaves. It is as
    if all were dropped, and launched anew in this order. *)

val drop : t -> flight -> unit
(** [drop t f] removes [f] from the tree, and ends its sweep. *)

(** The work done so far, for measurements. *)
type work = {
  sweeps : int;
  neighbours : int;  (** the pairs of parts that were found in the tree, and once again each part of a launch *)
  casts : int;  (** the exact queries *)
}

val work : t -> work
(** The work done since {!create}. *)
