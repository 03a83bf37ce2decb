(** Laws of motion: what rule Steer evaluates. *)

open Scc_exact

type variable = X | Y | Z | Vx | Vy | Vz | Wx | Wy | Wz | Mass | Time | Dt
(** [X], [Y] and [Z]: position of the leaf's centroid, in the world. [Vx], [Vy] and [Vz]: velocity of that point,
    in the world. [Wx], [Wy] and [Wz]: spin of the leaf's process, in the world, in radians per unit of time.
    [Mass]: mass of the leaf. [Time]: model time. [Dt]: time since the last update of the law. *)

type comparison = Lt | Le | Gt | Ge | Eq | Ne

type expr =
  | Const of Rat.t
  | Open of Open_number.t  (** what depends on a parameter: a weight alone *)
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

(** What a law gives: a velocity of the leaf's centroid, and a spin if it gives one (reading I-24). *)
type motion = { velocity : vector; spin : vector option }

(** One of several motions, and its weight among them. *)
type kick = { motion : motion; weight : expr }

type t =
  | Inertial
  | Gives of motion  (** the new motion *)
  | Choose of kick list
  (** the new motion is drawn; the probability of each is its weight divided by the sum of all weights *)

val velocity_alone : vector -> motion
(** The motion with this velocity that leaves the spin as it is. *)

type fault =
  | Division_by_zero
  | Bad_quantum  (** a quantum of [round] that is not positive *)
  | Too_long  (** an intermediate number may need more than {!longest} bits *)
  | Negative_weight
  | No_weight  (** the weights of all kicks are 0 *)
  | Too_many
  (** the leaves of a process draw among more than {!most_outcomes} combinations of motions *)

val longest : int
(** The greatest length in bits of a number in the evaluation of a law: 2^24. *)

val most_outcomes : int
(** The greatest number of combinations of motions that the leaves of one process may draw among: 1,000,000. *)

val by_sign : comparison -> int -> bool
(** [by_sign c s] is true if [a] stands in the relation [c] to [b], where [s] is the sign of [a] - [b]. *)

val compare_rationals : comparison -> Rat.t -> Rat.t -> bool
(** [compare_rationals c a b] is true if [a] stands in the relation [c] to [b]. *)

val eval : (variable -> Rat.t) -> expr -> (Rat.t, fault) result
(** [eval env e] is the exact value of [e], where [env] gives the values of its variables; or the first fault of
    its evaluation. [If], [And] and [Or] evaluate only what their value depends on. *)

val form :
  divisor:(Rational_function.t -> bool) -> (variable -> Rat.t) -> expr -> (Rational_function.t, fault) result
(** [form ~divisor env e] is the function of the parameter whose value {!eval} gives. It is [Division_by_zero] if
    a divisor does not pass the test [divisor]. What is rounded, and what conditions compare, does not depend on
    the parameter ({!misused}). *)

val misused : expr -> bool
(** [misused e] is true if a number that depends on a parameter is rounded or compared in [e]. *)

val equal : t -> t -> bool
(** [equal a b] is true if [a] and [b] are the same term; laws that differ in form but not in value are not
    equal. *)

val is_inertial : t -> bool
(** [is_inertial law] is true if [law] is [Inertial]: it never changes a motion. *)

val draws : t -> bool
(** [draws law] is true if [law] leaves the motion to chance (rule Draw). *)

val gives_spin : t -> bool
(** [gives_spin law] is true if [law] gives a spin, or some of the motions that it chooses from have one. *)

val mentions : (variable -> bool) -> t -> bool
(** [mentions test law] is true if a variable that satisfies [test] occurs in [law]. *)

val is_constant : t -> bool
(** [is_constant law] is true if [law] has no variables: its value is the same for all bodies, places and times. An
    [Inertial] law is constant in this sense. *)

val never_fails : t -> bool
(** [never_fails law] is true if [law] is constant and has no fault. Laws of several leaves that are bound together
    may still be {!Too_many}. *)

val mentions_time : t -> bool
(** [mentions_time law] is true if [Time] occurs in [law]. *)

val mentions_position : t -> bool
(** [mentions_position law] is true if [X], [Y] or [Z] occurs in [law]. *)
