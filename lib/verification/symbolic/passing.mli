(** Rule Time for zones: the next events, and the effect of time until then. *)

open Scc_polyhedra
open Scc_state_sets

(** An event that ends a passing of time, or happens at its end. *)
type due =
  | Contact of int
  (** the two parts at this place among {!Instant.pairs} collide, or open features of them meet (reading
      I-33) *)
  | Expiry of int * Linear.t
  (** the eps of a leaf whose duration is this form over the parameters (rule TimeBehaviour) *)
  | Split_instant of int  (** the next one of the process whose first leaf it is (reading I-9) *)
  | Step_end  (** the end of the movement step of the network (rule Steer) *)
  | Lots  (** the next split instant of the network (rule Lot) *)

val cells : Instant.context -> Zone.t -> Polyhedron.t -> due First.cell list
(** [cells c z region] divides a region without urgent events by the events that come first. *)

val until : Instant.context -> Zone.t -> due First.cell -> Zone.t list
(** [until c z cell] are the states of the cell's region at the cell's time, which exists, after the delays
    that expire then. There are several zones if delays that begin then may have the length 0. They have the
    same variables, and are not canonical. *)

val within : Instant.context -> Zone.t -> due First.cell -> Zone.t
(** [within c z cell] are all states from now until before the cell's time (all later states, if it has none),
    as a [Zone.t.halted] zone. The zone has one more variable, the last one: the time that has passed. *)

val trajectory : Instant.context -> Zone.t -> due First.cell -> Zone.t
(** [trajectory c z cell] are all states strictly after now and before the cell's time, as they pass by. The
    zone has one more variable, the last one: the time that has passed. *)

val settled : Instant.context -> Zone.t -> Zone.t list
(** The zone, cut in two where a delay that has just begun may have the length 0. In one part it expires (rule
    Eps0). *)
