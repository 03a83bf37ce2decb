(** A drawn solid in convex parts, under the names of its own faces and vertices. *)

open Scc_geometry

type t = private {
  drawn : Drawn.t;
  parts : (string * Polyhedron.t) array;
  (** [p1], [p2], …; a face that shows a region has its name, and a corner at a vertex of the set that of the
      vertex *)
  shows : (Drawn.feature, (int * Feature.t) list) Hashtbl.t;
}

val make : ?tick:(left:int -> unit) -> limit:int -> Drawn.t -> Polyhedron.t list -> t option
(** From convex parts, which are cut further ({!Refined.parts}, where [tick] is told). [None] if
    there would be more parts than the limit. *)

val inside : t -> Drawn.feature -> (int * Feature.t) list
(** The features of parts that show a region, without its borders and corners, a border without its ends, or a
    corner. *)

val closed : t -> Drawn.feature -> (int * Feature.t) list
(** Of its closure. *)

(** What a name of the set stands for. *)
type found =
  | Shown of Drawn.feature
  | Flat  (** a vertex or an edge inside a face or an edge that goes straight on: no feature of the solid *)
  | Turned of string  (** the corners of that face the wrong way round *)
  | Nothing

val face_or_vertex : t -> string -> found
val vertex : t -> string -> int option
val tuple : t -> int list -> found
(** One vertex, the two of an edge, or the corners of a face as the set has it. *)
