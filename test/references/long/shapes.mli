(** The shapes of the long test, their turns and their sizes. *)

open Scc_exact
open Scc_geometry
module Naive = Scc_naive.Naive

type shape = {
  name : string;
  plain : Naive.solid;
  polyhedron : Polyhedron.t;
}

(** A shape under a linear map of positive determinant. *)
type body = { shape : shape; linear : Mat.t }

type t

val make : Rng.t -> hulls:int list -> t
(** The fixed shapes, and for each number a hull of about so many vertices near a sphere. *)

val pair : t -> Rng.t -> body * body
(** Mostly of few vertices; often in orientations that make faces and edges parallel. *)

val corners : shape -> int
val place : body -> Naive.solid
(** Its image, about its reference point. *)

val show : body -> string
(** Everything needed to build it again. *)
