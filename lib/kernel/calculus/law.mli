(** Laws of motion: what rule Steer evaluates. *)

open Scc_exact

type variable = X | Y | Z | Vx | Vy | Vz | Mass | Time | Dt
(** Position of the leaf's centroid (world), velocity of its process, mass of the leaf, model time, time
    since the last update. *)

type comparison = Lt | Le | Gt | Ge | Eq | Ne

type expr =
  | Const of Rat.t
  | Var of variable
  | Neg of expr
  | Add of expr * expr
  | Sub of expr * expr
  | Mul of expr * expr
  | Div of expr * expr
  | Round of expr * expr  (** to the nearest multiple of the second *)
  | If of cond * expr * expr

and cond =
  | Bool of bool
  | Compare of comparison * expr * expr
  | And of cond * cond
  | Or of cond * cond
  | Not of cond

type vector = expr * expr * expr

(** One of several velocities, and how much it counts among them. *)
type kick = { velocity : vector; weight : expr }

type t =
  | Inertial
  | Velocity of vector  (** the new velocity *)
  | Choose of kick list  (** the new velocity is drawn, each with the share that its weight has in their sum *)

type fault =
  | Division_by_zero
  | Bad_quantum  (** a quantum of [round] that is not positive *)
  | Too_long  (** a number of more than {!longest} bits on the way *)
  | Negative_weight
  | No_weight  (** the weights of all kicks are 0 *)
  | Too_many
  (** more than {!most_outcomes} pairs, of what some leaves of a process draw and what the next one does *)

val longest : int
val most_outcomes : int

val compare_rationals : comparison -> Rat.t -> Rat.t -> bool
val eval : (variable -> Rat.t) -> expr -> (Rat.t, fault) result

val equal : t -> t -> bool
val is_inertial : t -> bool

val draws : t -> bool
(** Whether it leaves the velocity to chance. *)

val mentions : (variable -> bool) -> t -> bool
(** Whether one of these variables occurs. *)

val is_constant : t -> bool
(** Whether it gives the same wherever and whenever it is asked, to whomever (an inertial law is not asked). *)

val mentions_time : t -> bool
(** Whether [Time] occurs. *)

val mentions_position : t -> bool
(** Whether it depends on where the body is. *)
