(** How values are computed, and to which precision. *)

open Scc_exact

type engine =
  | Exactly  (** in rationals; beyond the limits the computation is given up *)
  | Nearly  (** as intervals that are proved in floats *)
  | Either  (** exactly within the limits, and nearly beyond them *)

type t = {
  engine : engine;
  component : int;  (** for exact values: the greatest strong component whose linear system is solved, in nodes *)
  bits : int;  (** for exact values: their greatest length (numerator and denominator together) *)
  width : Rat.t;  (** for intervals, positive: an interval of at most this width is good enough *)
  relative : bool;  (** the width is a share of the lower end *)
  bound : Answer.bound option;  (** for intervals: one that decides this bound is good enough, too *)
  interrupted : unit -> bool;  (** called now and then: [true] ends the computation with its present results *)
}

val default : t
(** [Either], with components of 1 000 nodes and numbers of 20 000 bits. Intervals have an absolute width of 10^-6
    and no bound. It is never interrupted. *)
