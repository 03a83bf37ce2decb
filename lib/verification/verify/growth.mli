(** Why an exploration did not close, as far as can be seen from the part of it that there is: which values keep
    being new. It proves nothing, since what was not explored may be otherwise, and is told as what is likely. *)

open Scc_exact
open Scc_calculus
open Scc_state_space

(** How far a number has grown along a run: the most bits that it took in each quarter of it. *)
type bits = { quarter : int; half : int; three_quarters : int; at_end : int }

type cause =
  | Steps of { bits : bits }
  (** a law of motion starts its movement steps anew at collisions, and the denominators of the instants grow *)
  | Numbers of { leaf : int; quantity : Length.quantity; bits : bits }
  (** the numbers of a body grow; of the body whose numbers are the longest at the end *)
  | Leaves of { leaves : int list; from : Rat.t; until : Rat.t }
  (** the process with these leaves goes away from all others, from this distance (squared) to that one, while all
      else comes back to where it was *)
  | Drifts of { by : Vec.t }  (** all comes back, but for where it is: everything is moved by this *)
  | Times  (** all comes back, but for the absolute time *)
  | Orders of { states : int; instants : int }
  (** so many of the states found last begin at so few instants, and differ by the order of events or by which of
      them happened *)
  | Splits of { states : int; instants : int }  (** the same by which weak splits have happened so far *)

val looks : (Network_lts.context -> State_graph.t -> cause list) list
(** All that is looked at, the most likely causes first. They find none when nothing of this is seen, or when no
    bound on states, bits, seconds or memory has ended the exploration. A bounded number of states is looked at:
    those of the path to the deepest state that was not expanded, and those found last. *)

val together : cause list -> cause list -> cause list
(** Of two explorations: each kind once. *)

val kind : cause -> string
(** For programs: ["steps"], ["numbers"], ["leaves"], ["drifts"], ["times"], ["orders"], ["splits"]. *)

val leaves : cause -> int list
(** The bodies that it is about, by number; none when it is about all of them. *)

val to_string : Model.t -> cause -> string
(** What was seen. *)

val cure : Model.t -> cause -> string
(** What helps. *)
