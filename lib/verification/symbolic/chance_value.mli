(** The probability of an until as a function of the parameters (rules Zones and Probability). *)

open Scc_polyhedra

(** How values are put together: where the run goes on by free choice, and where it goes on by chance. *)
type mode = {
  choice : [ `Least | `Greatest ];
  chance : [ `Mean | `Least | `Greatest ];
}

val new_constraints : within:Polyhedron.t -> Polyhedron.t -> Constraint.t list
(** [new_constraints ~within set] are the constraints of [set] that are none of [within]. *)

val solve :
  ?most:int -> progress:(sets:int -> all:int -> unit) -> Chance_graph.t -> mode -> parameters:int -> Piecewise.t
(** [solve ?most ~progress t mode ~parameters] is the value of the runs that satisfy the until, 1 if they do and 0
    if they do not, as a function of the starts, which are values of so many parameters. Its ends are those for
    unknown states that fail, and that satisfy it. What follows the first [most] layers is as unknown. *)
