(** How values are computed, and to which precision. *)

open Scc_exact

type engine =
  | Exactly  (** in rationals; beyond the limits the computation is given up *)
  | Nearly  (** as intervals that are proved in floats *)
  | Either  (** exactly within the limits, and nearly beyond them *)

type t = {
  engine : engine;
  bits : int;  (** for exact values: their greatest length (numerator and denominator together) *)
  steps : int;  (** for exact values: how many products of small numbers all systems may take ({!Lifting}) *)
  layers : int;
  (** for bounds of time: how many instants are worked through before later ones are enclosed, positive. If that is
      not enough, there are up to 16 times as many. *)
  width : Rat.t;  (** for intervals, positive: an interval of at most this width is good enough *)
  relative : bool;  (** the width is a share of the lower end *)
  bound : Answer.bound option;  (** for intervals: one that decides this bound is good enough, too *)
  interrupted : unit -> bool;  (** called now and then: [true] ends the computation with its present results *)
  half : unit -> unit -> bool;
  (** [half ()] is [interrupted] for work that begins now and may take half of the time that is left. *)
  quarter : unit -> unit -> bool;  (** the same for a quarter *)
  not_exact : Lifting.given_up -> unit;
  (** called where the engine [Either] gives intervals, with the reason why exact values were given up *)
}

val default : t
(** [Either], with numbers of 200 000 bits, 2{^30} steps and 20 000 instants. Intervals have an absolute width of
    10^-6 and no bound. It is never interrupted, and
    [not_exact] does nothing. *)

val most_layers : t -> int
(** The greatest number of instants that are worked through: 16 times [layers]. *)
