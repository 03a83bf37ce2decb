(** A drawn solid in convex parts, under the names of its own faces and vertices. *)

open Scc_geometry

type t = private {
  drawn : Drawn.t;
  parts : (string * Polyhedron.t) array;
  (** [p1], [p2], …; a face that shows a region has its name, and a corner at a vertex of the set that of the
      vertex *)
  shows : (Drawn.feature, (int * Feature.t) list) Hashtbl.t;
  joints : (Joints.site * Joints.site) list;  (** of all parts ({!Joints.forest}) *)
}

val make : ?tick:(left:int -> unit) -> ?names:bool -> limit:int -> Drawn.t -> Polyhedron.t list -> t option
(** [make ~limit drawn parts] are the convex parts [parts] of the solid, cut further as {!Refined.parts} does,
    with names. With [~names:false] they stay as they are, a face that shows several regions has the name of the
    first one, and [shows] has faces alone. [tick] gets the number of parts left. [None] if there would be more
    than [limit] parts. *)

val named : Drawn.t -> Polyhedron.t -> (Feature.t * Drawn.feature list) list -> Polyhedron.t
(** [named drawn p shown] is [p] with the names that a part has. The list says what the faces of [p] show. *)

val inside : t -> Drawn.feature -> (int * Feature.t) list
(** The features of parts that show the relative interior of a feature: a region without its borders and
    corners, a border without its ends, or a corner. Each is the number of a part and a feature of it. *)

val closed : t -> Drawn.feature -> (int * Feature.t) list
(** The features of parts that show a feature or its boundary ({!Drawn.closure}). Each is the number of a part
    and a feature of it. *)

(** What a name of the set stands for. *)
type found =
  | Shown of Drawn.feature
  | Flat  (** a vertex or an edge inside a region, or a vertex inside a border: no feature of the solid *)
  | Turned of string  (** the corners of the face of this name, in reverse order *)
  | Nothing

val face_or_vertex : t -> string -> found
(** [face_or_vertex t name] is the region of the face with this name, else the corner at the vertex with this
    name. [Flat] if there is no corner at that vertex; [Nothing] if no face or vertex has the name. *)

val vertex : t -> string -> int option
(** The number of the vertex with this name in the set; [None] if there is none. *)

val tuple : t -> int list -> found
(** The feature that a tuple of vertices names: one vertex, the two vertices of an edge, or the corners of a
    face in the order of the set. *)
