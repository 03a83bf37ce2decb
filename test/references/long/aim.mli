(** Offsets and velocities for a pair of solids: by chance, and exactly degenerate. *)

open Scc_exact
module Naive = Scc_naive.Naive
module Fast = Scc_naive.Fast

type pair = {
  a : Naive.solid;
  b : Naive.solid;
  fast : Fast.t;
  normals : Ivec.t array;  (** of the facets of the difference *)
  centre : Vec.t;  (** an offset deep inside *)
  extent : Vec.t;  (** of the difference along the axes, about *)
}

val pair : Naive.solid -> Naive.solid -> Fast.t -> pair

type case = {
  kind : string;
  r : Vec.t;
  w : Vec.t;
  known : Naive.cast option;  (** the answer of the cast, where the construction gives it *)
}

val random : Rng.t -> pair -> case
val degenerate : Rng.t -> pair -> case
