(** Equivalences of states. Each state of an exploration stands for its class. *)

open Scc_calculus
open Scc_property

type t = {
  symmetry : Symmetry.t;  (** states that differ by a permutation of interchangeable leaves *)
  translation : bool;  (** states that differ by a translation of the whole network *)
  drift : Drift.t option;  (** states that differ in the distances between bodies that never meet again *)
  forgets : bool;
  (** states in which several processes wait to draw, and that differ only in velocities that these lose by it: a
      process whose laws do not depend on its velocity has none (rule JoinedDraws) *)
  isometries : Isometry.t list;
  (** states of which one is the image of the other under a turn or a mirror image of space (rule Isometry); there
      are none with [translation] or [drift] *)
}

val none : t
(** The equivalence in which each state is a class of its own. *)

val translatable : Model.t -> State.t -> Property.temporal list -> bool
(** [translatable m s formulas] is true if nothing depends on the place of the whole. That is so if no law of [m]
    and no formula depends on positions, and no process of [s] is fixed. *)

val is_lost : Model.t -> State.process -> bool
(** [is_lost m p] is true if the next velocity of [p] does not depend on its velocity: the law of each leaf draws
    or gives one without reading [vx], [vy] or [vz]. *)

(** {1 Of the tuples of a catalogue} *)

type within

val within : t -> Catalogue.t -> within
(** The equivalence on the tuples of a catalogue, with empty caches. *)

val is_none : within -> bool
(** [is_none w] is true if each state is a class of its own. *)

val renames : within -> bool
(** [renames w] is true if a representative may have other names of leaves than the states of its class. *)

val representative : within -> int array -> int array
(** The representative of the class of a state. If it is the state itself, the result may be the same array. *)

val same_but_for_places : within -> int array -> int array -> bool
(** [same_but_for_places w a b] is true if [a] and [b] differ only in the distances between bodies that never
    meet again, with the same names of leaves. It is false without drift. *)

val keeps : within -> int array -> Property.quantity -> bool
(** [keeps w tuple q] is true if translations of bodies that never meet again keep the value of [q] in this
    state. It is true without drift. *)
