(** How values are worked out, and how far. *)

open Scc_exact

type engine =
  | Exactly  (** rationals; what passes the limits is given up *)
  | Nearly  (** intervals, proved in floats *)
  | Either  (** exactly where that is within the limits, nearly elsewhere *)

type t = {
  engine : engine;
  component : int;  (** of exact values: the greatest strong component of which a linear system is solved *)
  bits : int;  (** of exact values: the greatest length of one (numerator and denominator together) *)
  width : Rat.t;  (** of intervals, positive: one that is not wider is good enough *)
  relative : bool;  (** the width is a share of the lower end *)
  bound : Answer.bound option;  (** of intervals: one that decides this is good enough, too *)
  interrupted : unit -> bool;  (** asked now and then: to end with what is known then *)
}

val default : t
(** [Either]; components of 1 000, numbers of 20 000 bits; 10^-6, absolutely, and no bound; never interrupted. *)
