(** What is wrong with a face set, and where: the witnesses of {!Scc_geometry.Solid_report}, to be drawn. *)

open Scc_geometry

type t = {
  badge : string;  (** of each another: the number of a fault, or ["c6"] for a condition of Definition 4.3 *)
  text : string;
  faces : int list;
  edges : (int * int) list;  (** pairs of vertices *)
  vertices : int list;
}

val all : Solid_report.t -> t list
(** The faults, as many as are listed in text, then the conditions of Definition 4.3 that fail. All indices are in
    range. *)

val more : Solid_report.t -> int
(** How many faults are left out. *)
