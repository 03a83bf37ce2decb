(** The events to come in a run. An event may be out of date when its time comes: it belongs to sweeps that have
    ended since, or to a body that has changed. Such events are left out. *)

open Scc_exact

type ends
(** Sweeps that end at one time. Most sweeps end with the movement step: so they share one event. *)

type 'body event =
  | Contact of { time : Rat.t; one : Flights.flight; two : Flights.flight; sweep_one : int; sweep_two : int }
  (** the two collide, if both have still these sweeps *)
  | Sweep_ends of { time : Rat.t; mutable ends : ends }
  | Horizon of { time : Rat.t; body : 'body; age : int }  (** an eps expires, or lots are to be drawn *)
  | Split_instant of { time : Rat.t; body : 'body; age : int }

type 'body t

val create : age:('body -> int) -> 'body t
(** [create ~age] is empty. [age] is a number that changes whenever the events of a body are out of date. *)

val add : 'body t -> 'body event -> unit
(** [add t event] takes O(log n) steps for n events, on average. *)

val watch : 'body t -> Flights.watch
(** The callbacks that add the contacts and the ends of sweeps which {!Flights} finds. *)

val time : 'body event -> Rat.t
(** The time of an event, since the start of the run. *)

val first : 'body t -> 'body event option
(** An event with the least time of all that are not out of date. It stays in the agenda. *)

val drop_first : 'body t -> unit
(** [drop_first t] removes the event that {!first} gave. *)

val ended : 'body t -> ends -> Flights.flight list
(** [ended t ends] has the flights of these sweeps, but for those that have another sweep by now. *)
