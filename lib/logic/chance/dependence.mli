(** How a value depends on a parameter: from its pieces ({!Parametric}), where it rises and falls, its extremes,
    and where it passes a test. All ends are exact. *)

open Scc_exact

(** {1 Sets of values of the parameter} *)

(** The numbers between two ends; an end belongs to them if it is included. *)
type interval = { low : Algebraic.t; low_included : bool; high : Algebraic.t; high_included : bool }

(** A part of an open interval: it is cut at points, in order. *)
type set = {
  first : bool;  (** whether the numbers before the first point belong to the set *)
  cuts : (Algebraic.t * bool * bool) list;
  (** each point, whether it belongs, and whether the numbers after it do *)
}

val everywhere : bool -> set
(** [everywhere b] is all numbers, or none. *)

val combine : (bool -> bool -> bool) -> set -> set -> set
(** [combine f a b] is the numbers for which [f] is true of their membership in [a] and in [b]. *)

val complement : set -> set
(** [complement a] is the numbers that are not in [a]. *)

val intervals : low:Rat.t -> high:Rat.t -> set -> interval list
(** [intervals ~low ~high a] is the part of [a] in the open interval from [low] to [high]: disjoint intervals that
    do not touch, increasing. *)

val where : low:Rat.t -> high:Rat.t -> Answer.bound -> Parametric.piece list -> set
(** [where ~low ~high bound pieces] is the values of the parameter for which the value satisfies the bound. *)

(** {1 Shape} *)

type trend = Rises | Falls | Constant

(** A value at a point, or the limit at an end of the range. *)
type level =
  | Exactly of Rat.t
  | Between of Rat.t * Rat.t  (** a number that is not computed exactly, with bounds less than 10^-12 apart *)
  | Unbounded  (** it grows beyond all bounds *)

type extreme = {
  at : Algebraic.t list;  (** all points at which the value may be the extreme one: no bounds tell them apart *)
  attained : bool;  (** false if it is the limit at an end of the range *)
  level : level;
}

type shape = {
  trends : (Algebraic.t * Algebraic.t * trend) list;
  (** the intervals on which the value rises, falls or is constant, which join each other; a value that rises may
      have the derivative 0 at single points *)
  extremes : (extreme * extreme) option;
  (** the least and the greatest value on the open range; [None] if it is constant *)
}

val shape : low:Rat.t -> high:Rat.t -> Parametric.piece list -> shape option
(** [shape ~low ~high pieces] is the shape of a value on the open interval from [low] to [high]; [None] if it is
    infinite somewhere. *)
