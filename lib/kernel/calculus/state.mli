(** States of a network: processes as flat trees of leaves and bonds (Definition 5.2, reading I-5) in
    canonical form, so that equality is structural congruence (rule State). *)

open Scc_exact
open Scc_rigid

type leaf = {
  leaf : int;  (** index into {!Model.leaves} *)
  position : Vec.t;  (** of the leaf's reference point, in the world *)
  turned : Quaternion.t;  (** how it has turned since it was declared; the identity where nothing turns *)
  waited : Rat.t;  (** how long ago its law was asked, where processes have steps of their own; else 0 *)
  behaviour : Behaviour.aged;
}

(** One end of a bond. *)
type finish = { at : int;  (** the leaf *) site : Site.t }

(** <a, {phi1, phi2}>; the lesser end first. *)
type bond = private { name : string; one : finish; two : finish }

val bond : string -> finish -> finish -> bond

(** Where the network is in its movement step, or a process in its own (rule Steer). *)
type phase =
  | Moving  (** not steered at this instant, and the step is not over *)
  | Due  (** the step is over, and this instant has not been steered *)
  | Steered  (** this instant has been steered *)

(** What chance has decided of a process whose law is asked (rule Draw). *)
type draw =
  | Waits  (** it has not drawn yet *)
  | Drawn of Vec.t  (** the velocity that it will have when all have drawn *)

(** The summands by which leaves release a bond, [omega(a, Phi) chance q. B] each, in order of the leaves: of
    those of its two leaves that have a chance for it. The others are free to choose among their own, and are here,
    too, once they have chosen. *)
type drawn = (int * Behaviour.t) list

(** What has been decided of a bond at a split instant of the network (rule Lot). *)
type lot =
  | Undecided
  | Let_go of drawn  (** it is to be released *)
  | Next of drawn  (** it is, before others that end at one of its leaves *)

type lots = {
  since : Rat.t;  (** the time since the last split instant of the network, less than the split step *)
  pending : (bond * lot) list;  (** in order; what is left to be drawn or released at this instant *)
}

type process = private {
  leaves : leaf array;  (** in order of [leaf]; not empty *)
  bonds : bond array;
  (** sorted; a tree over the leaves, with {!Model.Cyclic} any connected graph without loops and double edges *)
  velocity : Vec.t;  (** of the centre of mass *)
  spin : Vec.t;  (** angular velocity, radians per unit of time; zero in the translational calculus *)
  since : Rat.t;  (** how long ago its present turn began (rule Turn); 0 where nothing turns *)
  lasts : Rat.t option;
  (** how long its present turn lasts in all, 0 when it does not spin; [None] while its next turn is due to begin
      (rigid models alone) *)
  kept : Vec.t;
  (** with {!Model.Free_body}, the angular momentum about the centre of mass, which turns keep; else zero *)
  clock : Rat.t option;
  (** time since the split clock was set (reading I-9), modulo the split step (reading I-16), 0 with
      {!Model.Any_time}; [Some] iff a weak split is enabled *)
  phase : phase option;
  (** of what is steered, where processes have steps of their own ({!Model.of_each}); else [None] *)
  draw : draw option;
  (** of each process whose law is asked at this instant, while some of them waits to draw; else [None] *)
  lots : lots option;  (** [Some] iff {!Model.lots}; [since] is the same of all processes *)
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
(** Canonical order. The bonds must join the leaves into one (a bug if they are too few for that). *)

val map_leaves : (leaf -> leaf) -> process -> process
(** The function keeps the index of each leaf. *)

val renamed : (int -> int) -> process -> process
(** The process with other indices for its leaves, given by a function that takes no two to one. *)

val with_velocity : Vec.t -> process -> process

val with_turn : spin:Vec.t -> since:Rat.t -> lasts:Rat.t option -> process -> process
val with_kept : Vec.t -> process -> process
val with_clock : Rat.t option -> process -> process
val with_phase : phase option -> process -> process
val with_draw : draw option -> process -> process
val with_lots : lots option -> process -> process
val with_bond : bond -> process -> process
(** One more, between two of its leaves. *)

val compare_first : process -> process -> int
(** By their first leaves. *)

val make : processes:process list -> step:step option -> time:Rat.t option -> t

val mapi : (int -> process -> process) -> t -> t
(** Each by its place. The function keeps the first leaf of each. *)

val at : step:step option -> time:Rat.t option -> t -> t
(** The same processes. *)

val exchange : gone:process list -> come:process list -> t -> t
(** Without some of its processes, the same values in memory, and with others. *)

val home : t -> int -> process option
(** The process that has a leaf; [None] when it is gone (rule Absorb). *)

val gone : Model.t -> t -> int list
(** The leaves that no process has any more, in order (rule Absorb). *)

val leaf_of : process -> int -> leaf
(** The leaf of a process with this index into {!Model.leaves} (a bug when it has none). *)

val has_leaf : process -> int -> bool

val mass : Model.t -> process -> Rat.t option
(** [None] for a process that holds a fixed leaf. *)

val size : Model.t -> process -> int
(** The number of basic shapes. *)

val part_position : Model.t -> leaf -> int -> Vec.t
(** World position of the reference point of a part. *)

val placed : Model.t -> leaf -> int -> Placed.t
(** A part where it stands, turned as it is. *)

val centroid : Model.t -> leaf -> Vec.t
(** World position of the centroid of the leaf's shape. *)

val centre_of_mass : Model.t -> process -> Vec.t
(** World position of what a process turns about; the centroid of its first leaf if it is fixed. *)

val components : leaf array -> bond array -> (leaf list * bond list) list
(** The connected components, in order of their first leaves: the pieces that remain when bonds go. *)

val equal : t -> t -> bool
val compare : t -> t -> int
val hash : t -> int
val equal_phase : phase -> phase -> bool
val equal_process : process -> process -> bool
val hash_process : process -> int
val equal_bond : bond -> bond -> bool
val hash_bond : bond -> int
val compare_bond : bond -> bond -> int
