(** Pairs of turning bodies from seeds. The bodies have about the size of one, and turn by |spin| (since + span)/2
    <= 1/4: at most what one movement step allows. Numbers other than turned corners have powers of two as
    denominators, so that floats hold most of them exactly. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
module Naive = Scc_naive.Naive
module Turning = Scc_naive.Turning
module Rng = Scc_long.Rng

type shape = { name : string; plain : Naive.solid; solids : Solid.t * Solid.t }
(** The solids of the two bodies of a pair. *)

val shape : string -> Naive.solid -> shape
val cube : shape

val small : shape array
(** A cube, a tetrahedron, hulls of about ten points, and boxes: flat, small, and large. *)

val read : string -> shape
(** A file of test/data/geometry, at 1/1024 of its size. *)

type case = {
  shape_a : shape;
  shape_b : shape;
  a : Turning.body;
  b : Turning.body;
  span : Rat.t;
  grazes : bool;  (** made so that they touch at an instant without interpenetrating around it *)
}

val motions : case -> Motion.t * Motion.t
val show : case -> string

(** What a case is to be. The first three have [since] = 0, span 1 and turn about their reference points; [Hit] may
    be a near miss and the other way round where the bodies come closest edge to edge. *)
type kind =
  | Hit
  | Near_miss  (** within a sixth, or a little nearer *)
  | Far
  | Chance  (** whatever comes; some interpenetrate from the start *)
  | Grazing  (** at the closest they are apart by, or overlap by, something from 2^-4 to 2^-40 *)
  | Aligned  (** faces and edges are parallel and touch; spins along the axes, equal spins, none *)
  | Peak
  (** a corner is lowest over a face at 1/2, 1/3, 2/5 or 5/8, and touches it exactly, or is off by 2^-8 to 2^-50; A
      is a cube *)

val make : kind -> shape -> shape -> Rng.t -> case

val without_spin : case -> case
