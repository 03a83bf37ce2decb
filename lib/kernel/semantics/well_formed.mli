(** Well-formed networks (rule WellFormed, Definitions 4.4, 4.5 and 5.2): what every reachable state
    satisfies. Elaboration checks the declared network with places in the text; this is the same for any
    state, exactly. *)

open Scc_calculus

type fault =
  | Lost_leaf of int  (** a leaf of the model that is in no process *)
  | Repeated_leaf of int  (** in more than one place *)
  | Interpenetration of { first : int * int; second : int * int }  (** leaf and part of each *)
  | Bad_bond of State.bond  (** it names a leaf, part or feature that is not there *)
  | Loose_bond of State.bond  (** its features do not touch (Definition 5.2, reading I-3) *)
  | Not_a_tree of int  
  (** the bonds of this process do not join its leaves into a tree; with {!Model.Cyclic}, not into one, or two of
      them twice *)
  | Bound_absorber of int  (** a leaf of this process absorbs, and is not alone *)
  | Moving_wall of int  (** a process that holds a fixed leaf and has a velocity *)
  | Bad_clock of int
  (** a split clock where no weak split is enabled, none where one is, or one that is not in
      [0, split step) (reading I-9) *)
  | Bad_turn of int
  (** a turn or an orientation in the translational calculus, or a turn that began in the future (rule Turn) *)
  | Bad_step  (** a step where nothing is steered, none where something is, one that is out of range, or a draw
                  of somebody whose law is not asked, or that nobody waits for *)
  | Bad_lots  (** lots between split instants or for bonds that have none, or instants that are not those of all
                  (rule Lot) *)
  | Bad_time  (** a time where nothing needs it, none where something does, or a negative one *)

val check : Semantics.t -> State.t -> fault list
(** Empty for a well-formed state. For initial and reachable states: a declared one has no clocks yet. *)

val to_string : Model.t -> State.t -> fault -> string
