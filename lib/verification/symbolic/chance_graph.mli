(** The zones that a network reaches by its free choices and by chance (rules Zones and Probability), for one
    operator "f until g" of state predicates, with a bound of time or without, or for one mean.

    Zones are explored in layers, by the number of transitions that lead to them; what follows the end of a
    movement step comes after all other zones of that step. Sets of states with the same forms over their own
    variables are one node of their layer, whatever values of the parameters lead to them. What follows is the same
    for equal states. *)

open Scc_state_sets

type limits = {
  horizon : Scc_exact.Rat.t option;  (** of time, if it is a coordinate: later zones are not expanded *)
  depth : int;  (** the greatest number of layers before that of a zone that is expanded *)
  zones : int;  (** the greatest number of zones that are expanded *)
  stop : unit -> bool;  (** called before each zone; true stops the exploration *)
  attempt : 'a. (unit -> 'a) -> 'a option;  (** expands a zone; [None] if that is given up, which stops it, too *)
  progress : zones:int -> waiting:int -> depth:int -> Zone.t -> unit;
  (** called before a zone is expanded: how many were expanded, how many wait, its depth, and the zone *)
}

type t

(** The bounds that left zones unexpanded. *)
type met = { too_late : bool; too_deep : bool; too_many : bool; stopped : bool }

val explore : Instant.context -> Chance_claims.question -> limits -> Zone.t list -> t
(** [explore c q limits zones] explores from disjoint zones over the parameters alone. Raises
    {!Instant.Not_affine}, {!Law_cells.Bad_law} and {!Chance_steps.Bad}. *)

val question : t -> Chance_claims.question
(** What was explored for. *)

val met : t -> met
(** The bounds that were met. *)

val reasons : t -> string list
(** Why predicates are undecided somewhere, sorted. *)

val size : t -> int
(** The number of zones that were expanded. *)

val transitions : t -> int
(** The number of transitions found, of all zones. *)

val depth : t -> int
(** The number of layers: no run to a zone has more transitions. *)

val is_chain : t -> bool
(** [is_chain t] is true if nothing is left to a free choice. *)

val root : t -> Chance_tree.tree
(** What follows all starts. *)

val count_layers : t -> int
(** The number of layers of nodes. *)

val solve :
  ?most:int ->
  progress:(sets:int -> all:int -> unit) ->
  t ->
  forget:(Chance_tree.node -> unit) ->
  of_node:(Chance_tree.node -> unit) ->
  unit ->
  unit
(** [solve ?most ~progress t ~forget ~of_node] calls [of_node] for each node of the first [most] layers, which are
    all by default, after it was called for all nodes to which that one leads, and [forget] for all nodes of other
    layers. It shows the number of nodes before each. The result calls [forget] for the nodes of the first layers.
*)
