(** The zones that a network reaches by its free choices and by chance (rules Zones and Probability), for one operator
    "f until g" of state predicates, with a bound of time or without.

    Zones are explored in layers, by the number of transitions that lead to them. Sets of states that are known by the
    same forms over the parameters are one node of their layer. No zone is dropped because another one includes it,
    unless the forms are equal: then what follows is the same for each value of the parameters. *)

open Scc_polyhedra
open Scc_property
open Scc_state_sets

type question = {
  claim : Property.prop;  (** f *)
  goal : Property.prop;  (** g *)
  bound : Property.bound;  (** of the time at which g comes *)
}

type limits = {
  horizon : Scc_exact.Rat.t option;  (** of time, if it is a coordinate: later zones are not expanded *)
  depth : int;  (** the greatest number of transitions that lead to a zone that is expanded *)
  zones : int;  (** the greatest number of zones that are expanded *)
  stop : unit -> bool;  (** called before each zone; true stops the exploration *)
  progress : zones:int -> waiting:int -> depth:int -> unit;
}

type t

(** The bounds that left zones unexpanded. *)
type met = { too_late : bool; too_deep : bool; too_many : bool; stopped : bool }

val explore : Instant.context -> question -> limits -> Zone.t list -> t
(** [explore c q limits zones] explores from disjoint zones over the parameters alone. Raises
    {!Instant.Not_affine}, {!Law_cells.Bad_law} and {!Chance_steps.Bad}. *)

val met : t -> met
(** The bounds that were met. *)

val reasons : t -> string list
(** Why predicates are undecided somewhere, sorted. *)

val size : t -> int
(** The number of zones that were expanded. *)

val transitions : t -> int
(** The number of transitions found, of all zones. *)

val depth : t -> int
(** The greatest number of transitions that lead to a zone. *)

val is_chain : t -> bool
(** [is_chain t] is true if nothing is left to a free choice. *)

(** How values are put together: where the run goes on by free choice, and where it goes on by chance. *)
type mode = {
  choice : [ `Least | `Greatest ];
  chance : [ `Mean | `Least | `Greatest ];
}

val solve : t -> mode -> Piecewise.space -> Piecewise.t
(** [solve t mode space] is the value of the runs that satisfy the until, 1 if they do and 0 if they do not, as a
    function of the parameters, whose values are the domain of [space]. Its ends are those for unknown states that
    fail, and that satisfy it. *)
