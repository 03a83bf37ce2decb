(** Reductions of the state space, each of which can be switched off. Each keeps the verdicts of a fragment of the
    properties, and is used for this fragment alone (rules Symmetry, Translation, Order, Jump, Slice, AbsoluteTime,
    Drift, JoinedDraws, Isometry). *)

open Scc_calculus
open Scc_property

type kind =
  | Symmetry  (** states that differ by a permutation of interchangeable leaves are one: {!module-Symmetry} *)
  | Translation  (** states that differ by a translation of the whole network are one: {!Quotient} *)
  | Order  (** independent events of one instant happen in one order: {!Groups} *)
  | Jump  (** time does not stop at the ends of movement steps that change nothing (rule Jump) *)
  | Slice  (** what cannot influence a property is left out: {!module-Slice} *)
  | Drift  (** states that differ in the distances between bodies that never meet again are one: {!module-Drift} *)
  | Time  (** absolute times that no formula or law tells apart are one: {!Scc_property.Time_seen} *)
  | Draws  (** the draws of one instant are one transition: {!Joint_draws} *)
  | Isometry  (** states that are images under turns and mirror images of the scene are one: {!module-Isometry} *)

val equal : kind -> kind -> bool
(** [equal a b] is true if [a] and [b] are the same kind. *)

val all : kind list
(** All kinds, each once. *)

val name : kind -> string
(** The name of a kind as in options: ["symmetry"], ["translation"], ["order"], ["jump"], ["slice"], ["drift"],
    ["time"], ["draws"] or ["isometry"]. *)

val of_name : string -> kind option
(** The kind with this name; [None] if there is none. *)

val joins : kind list -> Model.t -> Property.check list -> bool
(** [joins kinds m checks] is true if draws of one instant are one transition for these checks: {!Draws} is used,
    chance decides something in [m], no body turns, and no check sees between draws ({!Between_draws.unseen}). *)

val seen_on_courses : kind list -> Model.t -> Property.check list -> Course_units.t list option
(** [seen_on_courses kinds m checks] is what the checks see of bodies that move between two draws. It is [None]
    if all states of such steps are to be distinguished: draws are not joined, some check reads velocities or
    asks for no number, or this is not known. *)

val quotient :
  kind list ->
  Model.t -> State.t ->
  checks:Property.check list ->
  searched:Property.temporal list ->
  evaluated:Property.temporal list ->
  Quotient.t
(** [quotient kinds m initial ~checks ~searched ~evaluated] is the equivalence of the used [kinds] that keeps the
    truth of all these formulas, which are those of [checks]. Formulas that are [evaluated] on the graph have
    their parts explained, and allow less symmetry than those that are [searched]. *)

val sees_far : kind list -> Model.t -> State.t -> Property.check list -> bool
(** [sees_far kinds m initial checks] is true if [Drift] is used and {!Drift.sees_far} holds: the checks depend
    on places however far bodies are from each other. *)

val visible :
  kind list ->
  deep:bool ->
  searched:Property.temporal list ->
  evaluated:Property.temporal list ->
  (int -> bool) option
(** [visible kinds ~deep ~searched ~evaluated] is the predicate of the leaves that the formulas depend on, if one
    order of independent events is enough; else [None]. One order is enough if {!Order} is used, all formulas are
    searches, and none depends on the network as a whole. [deep] is true if the depth of states is bounded; as
    other orders would change that depth, the result is [None]. *)

val without_jumps : kind list -> Model.t -> Model.t
(** [without_jumps kinds m] is [m], with movement steps as part of the state if {!Jump} is not among [kinds]. *)

val time_seen : kind list -> Model.t -> Property.check list -> Time_seen.t
(** The absolute times that must be distinguished for these checks and for the laws of motion: [Never] if states
    have no time, and [Always] if {!Time} is not among the kinds. *)
