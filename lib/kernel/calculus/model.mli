(** The part of a network that stays the same: its shapes, definitions, laws and steps. {!State} has the part that
    changes. *)

open Scc_exact
open Scc_geometry

(** A basic shape (Definition 4.4), without the components that change (v, omega and the translation
    of T). *)
type part = {
  name : string;  (** s, unique over the network: ["p"], ["q.left"] *)
  template : string;  (** the name of W *)
  solid : Solid.t;  (** linear(T)(W) *)
  offset : Vec.t;  (** from the leaf's reference point to that of the part, as declared *)
  open_offset : Uncertain.place option;
  (** the offset as affine forms over the parameters that have ranges, if it depends on them; [offset] is then its
      value at some values of these parameters *)
  mass : Rat.t;  (** m > 0; without meaning in a fixed leaf *)
}

(** The shape S of a leaf S[B] (Definition 4.5). *)
type leaf = {
  name : string;  (** ["p"], ["c[3]"] *)
  template : string;  (** the name of the shape or compound *)
  parts : part array;
  fixed : bool;  (** a wall: infinite mass, never moves *)
  absorbs : bool;  (** what hits it leaves the network (rule Absorb); it is fixed, without behaviour or bonds *)
  mass : Rat.t;  (** the sum over the parts *)
  law : Law.t;
  law_at : Scc_base.Span.t;  (** where the law is declared; {!Scc_base.Span.none} without a declaration *)
}

(** What a turning body keeps from one turn to the next (rule Turn). *)
type dynamics =
  | Constant_spin  (** its spin, as the paper's steps do *)
  | Free_body  (** its angular momentum, from which each turn computes the spin anew *)

(** The rigid calculus: bodies turn as they move, and contact is known within a resolution. *)
type rigid = {
  dynamics : dynamics;
  resolution : Rat.t;  (** a positive length *)
  round_orientation : int option;  (** orientations are rounded to quaternions of so many bits (rule Round) *)
}

(** Which processes share a movement step, and what ends it (rule Steer). *)
type steps =
  | Shared  (** one step of the whole network; a collision ends it *)
  | Own
  (** each process under a law has its own step; a collision ends those of the processes that collide
      ([timestep ... local]) *)
  | Steady  (** one step of the whole network; it always lasts its full time ([timestep ... steady]) *)

(** How connected collisions of one instant are resolved. *)
type collisions =
  | In_turn  (** two processes at a time, in every order (reading I-8) *)
  | Together  (** all of them as one (reading I-32) *)
  | Drawn  (** as [In_turn], and chance decides which urgent transition comes first (rule Ties) *)

(** When open, compatible channels bind whose active surfaces meet. *)
type binding =
  | On_collision  (** if the two processes collide (reading I-12) *)
  | On_contact  (** also if the two processes do not collide (reading I-33); not in rigid models *)

(** The graphs that bonds may form. *)
type bonds =
  | Acyclic  (** the bonds of a process are a tree (Definition 5.2) *)
  | Cyclic  (** two leaves of one process may bind as well (rule Close, reading I-37) *)

(** What becomes of a walker, a body whose law leaves its velocity to chance, that runs into another body without
    making a bond (rule Blocked). *)
type blocked =
  | Bounce  (** it bounces, as all bodies do *)
  | Stop  (** it stands still until it draws again *)
  | Wait  (** as [Stop]; and a velocity that is blocked before the next draw is not taken at all *)

(** When a bond that both its ends would release may be released (rule WeakSplit, reading I-9). *)
type splits =
  | Every of Rat.t  (** at the instants of a grid with this step, which starts anew with the split clock *)
  | Any_time  (** at any real instant, as in the calculus *)

type t = {
  leaves : leaf array;
  definitions : Behaviour.definitions;
  timestep : Rat.t;  (** Delta *)
  splits : splits;
  ranges : Ranges.t;  (** the parameters that are known by a range alone; {!Behaviour.Wait} has forms over them *)
  keeps_time : bool;  (** absolute time is part of the state: a law or a property needs it *)
  steered : bool;  (** some law is not inertial: movement steps are part of the state *)
  steps : steps;
  collisions : collisions;
  binding : binding;
  bonds : bonds;
  blocked : blocked;
  lots : bool;
  (** some weak split is left to chance: the split instants of the network are part of the state (rule Lot) *)
  round_velocity : int option;  (** velocities and spins are rounded to multiples of 2^-k (rule Round) *)
  rigid : rigid option;  (** [None]: the translational calculus, in which nothing turns *)
}

val of_all : t -> bool
(** [of_all m] is true if [m] is steered by one movement step of the whole network ({!Shared} or {!Steady}). *)

val of_each : t -> bool
(** [of_each m] is true if [m] is steered by movement steps of single processes ({!Own}). *)

val keeps_beat : t -> bool
(** [keeps_beat m] is true if [m] is steered by movement steps that no collision ends ({!Steady}). *)

val has_turns : t -> bool
(** [has_turns m] is true if [m] is rigid or rounds velocities. Then the state says if a turn of a process is due
    (rules Turn, Round). *)

val absorbs : t -> bool
(** [absorbs m] is true if some body of [m] takes what hits it out of the network (rule Absorb). *)

val rounds : t -> bool
(** [rounds m] is true if rule Round may change something: [m] rounds velocities or orientations. *)

val binds_on_contact : t -> bool
(** [binds_on_contact m] is true if bodies of [m] bind also without a collision: {!On_contact}. *)

val closes_rings : t -> bool
(** [closes_rings m] is true if bonds of [m] may close rings: {!Cyclic}. *)

val stops_walkers : t -> bool
(** [stops_walkers m] is true if walkers of [m] do not bounce: {!Stop} or {!Wait}. *)

val draws : t -> bool
(** [draws m] is true if a law of [m] leaves velocities to chance (rule Draw). *)

val leaves_to_chance : t -> bool
(** [leaves_to_chance m] is true if velocities ({!draws}) or splits (the field [lots]) of [m] are drawn. *)

val draws_ties : t -> bool
(** [draws_ties m] is true if chance decides which urgent transition of [m] comes first (rule Ties). *)

val decides_by_chance : t -> bool
(** [decides_by_chance m] is true if chance decides something in [m]: {!leaves_to_chance} or {!draws_ties}. *)

val straight : t -> bool
(** [straight m] is true if [m] is neither steered nor has turns or lots. Then each process moves in a straight
    line and is independent of all others until it collides. *)

val resolution : t -> Rat.t option
(** The resolution of a rigid model, a length; [None] for a translational one. *)

val part_count : t -> int
(** The number of basic shapes in all leaves together. *)

val site_name : t -> leaf:int -> Site.t -> string
(** [site_name m ~leaf site] is the name of a feature in messages, with that of its part: ["q.left.top"],
    ["p.[a,b]"]. *)

val same_offset : part -> part -> bool
(** [same_offset a b] is true if both parts have the same offset in their leaves, for all values of parameters. *)

val leaf_centroid : leaf -> Vec.t
(** The centroid of the leaf's shape, from its reference point, as declared. Parts are weighted by mass; in a fixed
    leaf, by volume. *)
