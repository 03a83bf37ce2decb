(** Likely reasons why an exploration did not close: values that keep being new in the explored part. They
    prove nothing, since the unexplored part may differ. *)

open Scc_exact
open Scc_calculus
open Scc_state_space

(** The growth of a number along a run: its greatest length in bits in each quarter. *)
type bits = { quarter : int; half : int; three_quarters : int; at_end : int }

type cause =
  | Steps of { bits : bits }
  (** a law of motion restarts its movement steps at collisions, and the denominators of the instants grow *)
  | Numbers of { leaf : int; quantity : Length.quantity; bits : bits }
  (** the numbers of a body grow; of the body whose numbers are the longest at the end *)
  | Leaves of { leaves : int list; from : Rat.t; until : Rat.t }
  (** the process with these leaves goes away from all others, from this distance (squared) to that one, while all
      else comes back to where it was *)
  | Drifts of { by : Vec.t }  (** everything repeats, displaced by this vector *)
  | Times  (** everything repeats, at another absolute time *)
  | Orders of { states : int; instants : int }
  (** so many of the states found last begin at so few instants. They differ by the order of events, or by the
      events that happened. *)
  | Splits of { states : int; instants : int }  (** so many of the states found last begin at so few instants,
                                                    and differ by the weak splits that have happened *)
  | Drawing of { states : int; instants : int }
  (** so many of the states found last begin at so few instants, and differ by what has been drawn *)
  | Grid of { states : int; of_ : int; step : Rat.t }
  (** over zones: so many of [of_] states found last only wait for the next instant of the grid of weak splits *)

val looks : (Network_lts.context -> State_graph.t -> cause list) list
(** The searches for likely causes, the most likely first. A search finds none if no cause is seen, or if no bound
    on states, bits, seconds or memory has ended the exploration. A bounded number of states is considered: those
    of the path to the deepest state that was not expanded, and those found last. *)

val together : cause list -> cause list -> cause list
(** The causes of two explorations, each kind once; those of the first have precedence. *)

val kind : cause -> string
(** A name for programs: ["steps"], ["numbers"], ["leaves"], ["drifts"], ["times"], ["orders"], ["splits"],
    ["draws"], ["grid"]. *)

val leaves : cause -> int list
(** The numbers of the leaves that the cause concerns; none if it concerns all of them. *)

val to_string : Model.t -> cause -> string
(** The observation, as a sentence for readers. *)

val cure : Model.t -> cause -> string
(** A remedy, as a sentence for readers. *)
