(** The faults of a face set with their places: the witnesses of {!Scc_geometry.Solid_report}, to be drawn. *)

open Scc_geometry

(** A fault, or a failing condition, with the features at fault. *)
type t = {
  badge : string;  (** unique: the number of a fault, or ["c6"] for a condition of Definition 4.3 *)
  text : string;
  faces : int list;
  edges : (int * int) list;  (** pairs of vertices *)
  vertices : int list;
}

val all : Solid_report.t -> t list
(** The faults, as many as the text lists, then the conditions of Definition 4.3 that fail. All indices are in
    range. *)

val more : Solid_report.t -> int
(** The number of faults that are left out. *)
