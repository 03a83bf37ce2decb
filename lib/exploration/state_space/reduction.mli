(** Ways to explore less, each of which can be switched off. Each keeps the verdicts of a fragment of the
    properties, and is not used outside of it (rules Symmetry, Translation, Order, Jump, Slice, AbsoluteTime,
    Drift). *)

open Scc_calculus
open Scc_property

type kind =
  | Symmetry  (** interchangeable leaves are told apart by their places alone: {!Symmetry} *)
  | Translation  (** networks that differ by a translation of the whole are one: {!Quotient} *)
  | Order  (** independent events of one instant happen in one order: {!Groups} *)
  | Jump  (** time does not stop at the ends of movement steps that change nothing (rule Jump) *)
  | Slice  (** what cannot influence a property is left out: {!Slice} *)
  | Drift  (** how far bodies that never meet again are from each other is not told apart: {!Drift} *)
  | Time  (** absolute time counts no further than formulas tell times apart: {!Time_seen} *)

val equal : kind -> kind -> bool
val all : kind list
val name : kind -> string
val of_name : string -> kind option

val quotient :
  kind list ->
  Model.t -> State.t ->
  checks:Property.check list ->
  searched:Property.temporal list ->
  evaluated:Property.temporal list ->
  Quotient.t
(** What keeps the truth of all these formulas, which are those of the checks. Those that are [evaluated] on the
    graph, and not just [searched] for, have their parts explained. *)

val sees_far : kind list -> Model.t -> State.t -> Property.check list -> bool
(** Whether checks tell places apart however far bodies are from each other, where {!Drift} could do without. *)

val visible :
  kind list ->
  deep:bool ->
  searched:Property.temporal list ->
  evaluated:Property.temporal list ->
  (int -> bool) option
(** The leaves that can be seen, when independent events need only be looked at in one order: for searches, of
    which none looks at the network as a whole. [deep]: the depth of states is bounded, which other orders would
    change. *)

val without_jumps : kind list -> Model.t -> Model.t
(** The model, with movement steps as part of the state when {!Jump} is not among the kinds. *)

val time_seen : kind list -> Model.t -> Property.check list -> Time_seen.t
(** How much of absolute time has to be told apart for these checks, and for the laws of motion. *)
