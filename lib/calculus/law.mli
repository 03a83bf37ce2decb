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

type t =
  | Inertial
  | Velocity of expr * expr * expr  (** the new velocity *)

type fault =
  | Division_by_zero
  | Bad_quantum  (** a quantum of [round] that is not positive *)
  | Too_long  (** a number of more than {!longest} bits on the way *)

val longest : int

val compare_rationals : comparison -> Rat.t -> Rat.t -> bool
val eval : (variable -> Rat.t) -> expr -> (Rat.t, fault) result

val equal : t -> t -> bool

val mentions_time : t -> bool
(** Whether [Time] occurs. *)

val mentions_position : t -> bool
(** Whether it depends on where the body is. *)
