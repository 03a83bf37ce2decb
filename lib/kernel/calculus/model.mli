(** The unchanging part of a network: its shapes, definitions, laws and steps. What changes is in
    {!State}. *)

open Scc_exact
open Scc_geometry

(** A basic shape (Definition 4.4), without the components that change (v, omega and the translation
    of T). *)
type part = {
  name : string;  (** s, unique over the network: ["p"], ["q.left"] *)
  template : string;  (** the name of W *)
  solid : Solid.t;  (** linear(T)(W) *)
  offset : Vec.t;  (** of its reference point from the leaf's *)
  open_offset : Uncertain.place option;
  (** the same over the parameters that have ranges, where it depends on them: [offset] is then what it is for some
      of their values *)
  mass : Rat.t;  (** m > 0; of no meaning in a fixed leaf *)
}

(** The shape S of a leaf S[B] (Definition 4.5). *)
type leaf = {
  name : string;  (** ["p"], ["c[3]"] *)
  template : string;  (** of the shape or compound *)
  parts : part array;
  fixed : bool;  (** a wall: infinite mass, never moves *)
  absorbs : bool;  (** what hits it is gone (rule Absorb); fixed, without behaviour, and bound to nobody *)
  mass : Rat.t;  (** the sum over the parts *)
  law : Law.t;
  law_at : Scc_base.Span.t;  (** where it is declared; {!Scc_base.Span.none} when nothing declares one *)
}

(** What a turning body keeps from one turn to the next (rule Turn). *)
type dynamics =
  | Constant_spin  (** its spin, as the paper's steps do *)
  | Free_body  (** its angular momentum: the spin is computed anew from it *)

(** The rigid calculus: bodies turn as they move, and contact is known within a resolution. *)
type rigid = {
  dynamics : dynamics;
  resolution : Rat.t;  (** a positive length *)
  round_orientation : int option;  (** orientations are rounded to quaternions of so many bits (rule Round) *)
}

(** Whose movement steps are, and what ends them (rule Steer). *)
type steps =
  | Shared  (** of the whole network; a collision ends them *)
  | Own  (** each process under a law has its own; a collision ends those of who collides ([timestep ... local]) *)
  | Steady  (** of the whole network; nothing ends them before their time ([timestep ... steady]) *)

(** How collisions of one instant that hang together are resolved. *)
type collisions =
  | In_turn  (** two processes at a time, in every order (reading I-8) *)
  | Together  (** as one (reading I-32) *)

(** When open, compatible channels bind whose active surfaces meet. *)
type binding =
  | On_collision  (** of two processes that collide (reading I-12) *)
  | On_contact  (** also of two that do not collide (reading I-33); not in rigid models *)

(** Whether bonds may close rings. *)
type bonds =
  | Acyclic  (** the bonds of a process are a tree (Definition 5.2) *)
  | Cyclic  (** two leaves of one process may bind as well (rule Close, reading I-37) *)

(** When a bond that both its ends would release may be released (rule WeakSplit, reading I-9). *)
type splits =
  | Every of Rat.t  (** at the instants of a grid, which is set anew with the split clock: every so often *)
  | Any_time  (** at any real instant, as in the calculus *)

type t = {
  leaves : leaf array;
  definitions : Behaviour.definitions;
  timestep : Rat.t;  (** Delta *)
  splits : splits;
  ranges : Ranges.t;  (** of the parameters that are not known: those that {!Behaviour.Wait} speaks of *)
  keeps_time : bool;  (** absolute time is part of the state: a law or a property needs it *)
  steered : bool;
  (** some law is not inertial: movement steps are part of the state *)
  steps : steps;
  collisions : collisions;
  binding : binding;
  bonds : bonds;
  lots : bool;  (** some weak split has a chance: split instants of the network are part of the state (rule Lot) *)
  round_velocity : int option;  (** velocities and spins are rounded to multiples of 2^-k (rule Round) *)
  rigid : rigid option;  (** [None]: the translational calculus, in which nothing turns *)
}

val of_all : t -> bool
(** Steered, by one movement step of the whole network. *)

val of_each : t -> bool
(** Steered, by movement steps of single processes. *)

val keeps_beat : t -> bool
(** Steered, by movement steps that no collision ends. *)

val has_turns : t -> bool
(** Rigid, or rounding velocities: whether a turn of a process is due is part of the state (rules Turn, Round). *)

val absorbs : t -> bool
(** Some body takes what hits it out of the network (rule Absorb). *)

val rounds : t -> bool
(** Rule Round may change something. *)

val binds_on_contact : t -> bool
(** Bodies bind also without a collision: {!On_contact}. *)

val closes_rings : t -> bool
(** Bonds may close rings: {!Cyclic}. *)

val draws : t -> bool
(** Whether a law leaves velocities to chance (rule Draw). *)

val leaves_to_chance : t -> bool
(** Something is drawn: velocities ({!draws}) or splits ({!lots}). *)

val straight : t -> bool
(** Neither steered nor with turns nor lots: a process moves in a straight line, and has to do with nobody until it
    collides. *)

val resolution : t -> Rat.t option
(** Of a rigid model. *)

val part_count : t -> int

val site_name : t -> leaf:int -> Site.t -> string
(** ["q.left.top"], ["p.[a,b]"]. *)

val same_offset : part -> part -> bool
(** Whether they are at one place in their leaves, for all values of parameters. *)

val leaf_centroid : leaf -> Vec.t
(** Mass centroid of the leaf about its reference point. *)
