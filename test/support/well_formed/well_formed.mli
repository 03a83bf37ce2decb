(** Well-formed networks (rule WellFormed, Definitions 4.4, 4.5 and 5.2): what every reachable state satisfies.
    Elaboration checks the declared network, with places in the text. This module checks any state, exactly. *)

open Scc_calculus
open Scc_semantics

type fault =
  | Lost_leaf of int  (** a leaf of the model that is in no process *)
  | Repeated_leaf of int  (** a leaf of the model that is in more than one place *)
  | Interpenetration of { first : int * int; second : int * int }
  (** two parts interpenetrate; each is the index of its leaf and its index in the leaf *)
  | Bad_bond of State.bond  (** it names a leaf, part or feature that is not there, or one leaf twice *)
  | Loose_bond of State.bond  (** its features do not touch (Definition 5.2, reading I-3) *)
  | Not_a_tree of int
  (** the bonds of this process do not join its leaves into a tree; with [Model.Cyclic], they do not connect
      them, or join two of them twice *)
  | Bound_absorber of int  (** a leaf of this process absorbs, and is not alone *)
  | Moving_wall of int  (** this process has a fixed leaf, and a velocity or a spin *)
  | Bad_clock of int
  (** this process has a split clock but no enabled weak split, or the reverse; or not
      0 <= clock < split step (reading I-9); or a clock that is not 0 with {!Scc_calculus.Model.Any_time} *)
  | Bad_turn of int
  (** this process has a turn or an orientation in the translational calculus, or a turn that is out of range (rule
      Turn) *)
  | Bad_step
  (** a movement step is missing, needless or out of range; or there is a draw of a process whose law is not
      evaluated now, or while no process waits to draw *)
  | Bad_lots
  (** lots are pending between split instants or for bonds that have none, or processes differ in the last split
      instant (rule Lot) *)
  | Bad_time  (** absolute time is missing, needless or negative *)

val check : Semantics.t -> State.t -> fault list
(** All faults of a state; the list is empty for a well-formed one. It is for initial and reachable states: a
    declared state has no clocks yet. *)

val to_string : Model.t -> State.t -> fault -> string
(** A fault as a sentence, with the names of the model. The state is the one in which {!check} found it. *)
