(* What follows the zones of a network, by free choices and by chance, for one question ({!Chance_graph}). *)

open Scc_exact
open Scc_polyhedra
open Scc_state_sets

(** What follows the states of a set. *)
type tree =
  | Won
  | Lost
  | Open  (** not known *)
  | Perhaps of tree list  (** one of these, and it is not known which *)
  | Is of Linear.t  (** the value of a number *)
  | Gain of { least : Linear.t; most : Linear.t; tree : tree }
  (** the time until what follows, or how many happenings lead there: at least and at most *)
  | Cells of (Polyhedron.t * tree) list  (** disjoint, and together the set *)
  | Drawn of (Rat.t * tree) list
  | Free of (Polyhedron.t * tree) list  (** ways to go on, each for the states of a set *)
  | Stopping of Polyhedron.t * tree
  (** one way to go on for each value of one more variable, the last one, that is in the set *)
  | Later of { node : node; set : Polyhedron.t; forms : Linear.t array }
  (** the states of a node in a set; the forms are its variables over those from here *)

(** Zones of one kind with the same forms over their own variables. Each set of a node is expanded by itself. *)
and node = {
  zone : Zone.t;
  mutable sets : Polyhedron.t list;
  mutable trees : (Polyhedron.t * tree) list;  (** of each set, when it is expanded *)
  mutable values : (Polyhedron.t * Piecewise.t) list;  (** of each set, while the layer before is solved *)
  mutable means : (Polyhedron.t * Affine.t) list;  (** of each set in the same way, for a mean *)
}

