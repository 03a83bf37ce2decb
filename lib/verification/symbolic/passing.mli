(** Rule Time for zones: what comes first, and what time makes of them until then. *)

open Scc_polyhedra

(** What ends a passing of time, or happens at its end. *)
type due =
  | Contact of int
  (** of the two parts that have this place among {!Instant.pairs}: they collide, or open features of them come to
      meet (reading I-33) *)
  | Expiry of int * Linear.t
  (** the eps of a leaf whose duration is this form over the parameters (rule TimeBehaviour) *)
  | Split_instant of int  (** the next one of the process whose first leaf it is (reading I-9) *)

val cells : Instant.context -> Zone.t -> Polyhedron.t -> due First.cell list
(** On a region of the zone on which nothing urgent is to be done, what comes first. *)

val until : Instant.context -> Zone.t -> due First.cell -> Zone.t list
(** What the zone has become on the region of a cell at the time that the cell says (there is one): after the
    delays that expire then. Several, where delays that begin then may have the length 0. Over the same variables;
    not canonical. *)

val within : Instant.context -> Zone.t -> due First.cell -> Zone.t
(** All states from now until before the time of the cell (all that come, where it has none), {!Zone.t.halted}:
    over one variable more, the last one, which says how much time has passed. *)

val trajectory : Instant.context -> Zone.t -> due First.cell -> Zone.t
(** The same states as they pass by, strictly after now. *)

val may_split : Zone.t -> bool
(** A weak split is enabled in some process. *)

val on_grid : Instant.context -> bool
(** Weak splits happen at instants of a grid alone ({!Scc_calculus.Model.Every}). *)

val settled : Instant.context -> Zone.t -> Zone.t list
(** Where delays that have just begun may have the length 0, the zone is cut in two, and they expire in one part
    (rule Eps0). *)

val not_over : Instant.context -> Zone.t -> Constraint.t list
(** What time says of all zones that are {!settled}: ages are not negative and less than all delays that wait, and
    so are clocks, on a grid, which may be at its next instant. *)
