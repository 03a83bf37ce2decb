(** States of a network: processes as flat trees of leaves and bonds (Definition 5.2, reading I-5) in
    canonical form, so that equality is structural congruence (rule State). *)

open Scc_exact
open Scc_rigid

type leaf = {
  leaf : int;  (** index into {!Model.leaves} *)
  position : Vec.t;  (** world position of the leaf's reference point *)
  turned : Quaternion.t;  (** its rotation since it was declared; the identity where nothing turns *)
  waited : Rat.t;  (** the time since its law was evaluated, where processes have steps of their own; else 0 *)
  behaviour : Behaviour.aged;
}

(** One end of a bond. *)
type finish = { at : int;  (** the leaf *) site : Site.t }

(** [<a, {phi1, phi2}>]; the lesser end first. *)
type bond = private { name : string; one : finish; two : finish }

val bond : string -> finish -> finish -> bond
(** [bond name a b] is the bond of this name between the ends [a] and [b], given in any order. *)

(** Where the network is in its movement step, or a process in its own (rule Steer). *)
type phase =
  | Moving  (** not steered at this instant, and the step is not over *)
  | Due  (** the step is over, and this instant has not been steered *)
  | Steered  (** this instant has been steered *)

(** What chance has decided of a process whose laws are evaluated at this instant (rule Draw). *)
type draw =
  | Waits  (** it has not drawn yet *)
  | Drawn of Given.t  (** the motion that it will have when all have drawn *)

(** The summands [omega(a, Phi) chance q. B] by which leaves release a bond, in order of the leaves. There is one
    for each of its two leaves that has a chance for it. A leaf without a chance chooses freely among its summands,
    and is listed once it has chosen. *)
type drawn = (int * Behaviour.t) list

(** What has been decided of a bond at a split instant of the network (rule Lot). *)
type lot =
  | Undecided
  | Let_go of drawn  (** it is to be released *)
  | Next of drawn  (** it is to be released before others that end at one of its leaves *)

type lots = {
  since : Rat.t;  (** the time since the last split instant of the network, less than the split step *)
  pending : (bond * lot) list;  (** in order: the bonds still to be drawn for or released at this instant *)
}

type process = private {
  leaves : leaf array;  (** in order of [leaf]; not empty *)
  bonds : bond array;
  (** sorted; a tree over the leaves, with {!Model.Cyclic} any connected graph without loops and double edges *)
  velocity : Vec.t;  (** of the centre of mass, in the world *)
  spin : Vec.t;  (** angular velocity in the world, radians per unit of time; zero in the translational calculus *)
  since : Rat.t;  (** the time since its present turn began (rule Turn); 0 where nothing turns *)
  lasts : Rat.t option;
  (** the whole length of its present turn, 0 if it does not spin; [None] while its next turn is due to begin, in
      models with {!Model.has_turns} *)
  kept : Vec.t;
  (** with {!Model.Free_body}, the angular momentum about the centre of mass in the world, which turns keep; else
      zero *)
  clock : Rat.t option;
  (** the time since the split clock was set (reading I-9), modulo the split step (reading I-16); 0 with
      {!Model.Any_time}; [Some] iff a weak split is enabled *)
  phase : phase option;
  (** [Some] for a steered process, where processes have steps of their own ({!Model.of_each}); else [None] *)
  draw : draw option;
  (** [Some] for each process whose laws are evaluated at this instant, while one of these processes waits to draw;
      else [None] *)
  lots : lots option;  (** [Some] iff {!Model.lots}; [since] is equal in all processes *)
}

(** The movement step of the network, where it has one ({!Model.of_all}). *)
type step = {
  remaining : Rat.t;  (** 0 <= r <= {!Model.timestep}; 0 only while [Due] *)
  phase : phase;
}

type t = private {
  processes : process array;  (** in order of their first leaves *)
  step : step option;
  time : Rat.t option;  (** absolute, only when {!Model.keeps_time} *)
}

val process :
  ?phase:phase -> ?draw:draw -> ?lots:lots -> ?spin:Vec.t -> ?since:Rat.t -> ?lasts:Rat.t option -> ?kept:Vec.t ->
  leaves:leaf list -> bonds:bond list -> velocity:Vec.t -> clock:Rat.t option -> unit -> process
(** A process with leaves and bonds in canonical order. The bonds must join all leaves into one; too few bonds for
    that are a bug. The defaults are those of a process that neither turns nor is steered, without lots. *)

val map_leaves : (leaf -> leaf) -> process -> process
(** [map_leaves f p] is [p] with each leaf replaced by its image under [f], which keeps the index of the leaf. *)

val renamed : (int -> int) -> process -> process
(** [renamed image p] is [p] with the index of each leaf replaced, also in bonds and lots. [image] is injective on
    the leaves of [p]. *)

val with_velocity : Vec.t -> process -> process
(** [with_velocity v p] is [p] with the velocity [v] of the centre of mass. *)

val with_turn : spin:Vec.t -> since:Rat.t -> lasts:Rat.t option -> process -> process
(** [with_turn ~spin ~since ~lasts p] is [p] with this spin and this turn: when it began, and how long it lasts. *)

val with_kept : Vec.t -> process -> process
(** [with_kept l p] is [p] with the angular momentum [l] that its turns keep. *)

val with_clock : Rat.t option -> process -> process
(** [with_clock clock p] is [p] with this split clock. *)

val with_phase : phase option -> process -> process
(** [with_phase phase p] is [p] in this phase of its own movement step. *)

val with_draw : draw option -> process -> process
(** [with_draw draw p] is [p] with this decision of chance about its motion (rule Draw). *)

val with_lots : lots option -> process -> process
(** [with_lots lots p] is [p] with these lots (rule Lot). *)

val with_bond : bond -> process -> process
(** [with_bond b p] is [p] with one more bond, between two of its leaves. *)

val compare_first : process -> process -> int
(** The order of processes in a state: by the indices of their first leaves. *)

val make : processes:process list -> step:step option -> time:Rat.t option -> t
(** A state of these processes, given in any order. *)

val mapi : (int -> process -> process) -> t -> t
(** [mapi f s] is [s] with each process [p] at index [i] replaced by [f i p], which keeps the first leaf of [p]. *)

val restricted : t -> (int -> bool) -> t
(** [restricted s stays] is [s] with only the processes whose indices pass the test. *)

val with_leaves : t -> int list -> t
(** [with_leaves s leaves] is [s] with only the processes that have some of these leaves. *)

val at : step:step option -> time:Rat.t option -> t -> t
(** [at ~step ~time s] is the processes of [s], in this movement step and at this absolute time. *)

val exchange : gone:process list -> come:process list -> t -> t
(** [exchange ~gone ~come s] is [s] without the processes [gone], and with the processes [come]. Those that go are
    found by physical equality. *)

val members : process -> int list
(** [members p] are the indices of the leaves of [p], in order. *)

val leaves : t -> leaf list
(** [leaves s] are the leaves of all processes of [s], process by process. *)

val bonds : t -> bond list
(** [bonds s] are the bonds of all processes of [s], process by process. *)

val by_leaf : t -> (process * leaf) list
(** [by_leaf s] are the leaves of [s] in the order of their indices, each with its process. *)

val home : t -> int -> process option
(** [home s leaf] is the process that has the leaf; [None] if the leaf has been absorbed (rule Absorb). *)

val gone : Model.t -> t -> int list
(** [gone m s] is the indices of the leaves of [m] that no process of [s] has, in order: those that were absorbed
    (rule Absorb). *)

val leaf_of : process -> int -> leaf
(** [leaf_of p i] is the leaf of [p] with index [i] into {!Model.leaves}. It is a bug if [p] has no such leaf. *)

val has_leaf : process -> int -> bool
(** [has_leaf p i] is true if [p] has the leaf with index [i] into {!Model.leaves}. *)

val mass : Model.t -> process -> Rat.t option
(** The mass of a process, the sum over its leaves; [None] if one of its leaves is fixed. *)

val size : Model.t -> process -> int
(** The number of basic shapes in a process. *)

val part_position : Model.t -> leaf -> int -> Vec.t
(** [part_position m l i] is the world position of the reference point of part [i] of the leaf. *)

val placed : Model.t -> leaf -> int -> Placed.t
(** [placed m l i] is part [i] of the leaf at its place and in its orientation, in the world. *)

val centroid : Model.t -> leaf -> Vec.t
(** World position of the centroid of the leaf's shape. *)

val compare_places : Model.t -> leaf -> leaf -> int
(** An order of leaves by their places in the world, which neither names nor the order of declaration change. It
    compares reference points, then orientations, then the centroids of the first parts; [0] is for one leaf only,
    as parts do not interpenetrate. *)

val centre_of_mass : Model.t -> process -> Vec.t
(** World position of the point that a process turns about. For a process with a fixed leaf it is the centroid of
    its first leaf. *)

val components : leaf array -> bond array -> (leaf list * bond list) list
(** The connected components of leaves under bonds, in order of their first leaves. They are the pieces that remain
    of a process when some of its bonds are released. *)

val equal : t -> t -> bool
(** [equal s t] is true if [s] and [t] are structurally congruent (rule State). *)

val hash : t -> int
(** A hash that agrees with {!equal}. *)


val equal_process : process -> process -> bool
(** [equal_process p q] is true if [p] and [q] are equal in all fields, for the same leaves. *)

val hash_process : process -> int
(** A hash that agrees with {!equal_process}. *)

val equal_bond : bond -> bond -> bool
(** [equal_bond a b] is true if [a] and [b] have the same name and the same ends. *)

val hash_bond : bond -> int
(** A hash that agrees with {!equal_bond}. It reads the ends alone. *)

val compare_bond : bond -> bond -> int
(** A total order on bonds: by the lesser end, the greater end, then the name. *)
