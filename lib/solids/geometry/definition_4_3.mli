(** The seven conditions of Definition 4.3 as the paper prints them, each by itself, with a witness. They are
    for reports only. Templates are accepted by {!Polyhedron.of_ifs} (reading I-2), which implies the seven
    conditions. These conditions also admit sets that bound no convex solid.

    Readings: a face is a convex polygon (condition 4) when it is planar, simple and strictly convex. The angle
    of condition 6 is the dihedral angle, on the inner side, at each edge that exactly two faces share. So
    coplanar neighbours fail it. No condition mentions orientation. The inner side is either in front of all
    faces or behind them all, whichever makes fewer edges fail. An edge along which both faces run the same way
    has no inner side, and fails. The edges of condition 7 are unordered (reading I-1). Faces that name
    vertices outside V fail condition 2 and are ignored in 4 to 6. In condition 7 their edges are ignored, and
    they count in |F|. *)

type witness =
  | Too_few  (** 1: of vertices or of faces; the numbers are in {!t} *)
  | Foreign_vertex of int * int  (** 2: face, index that is no vertex *)
  | Collinear  (** 3: all vertices lie on one line *)
  | Not_convex_polygon of Polyhedron_fault.t
  (** 4: [Short_face], [Off_plane], [Degenerate_face] or [Self_crossing] *)
  | Equivalent of int * int  (** 5: two faces that are equal up to rotation (Definition 4.1) *)
  | Angle of int * int * int * int
  (** 6: faces f, g and their shared edge v, w, where the interior angle is 180 degrees or more, or has
      no meaning as a face has no plane *)
  | Euler  (** 7: the numbers are in {!t} *)

type t = {
  vertices : int;  (** |V| *)
  faces : int;  (** |F| *)
  edges : int;  (** |dg(F)|, unordered *)
  directed_edges : int;  (** |dg(F)| in ordered pairs, as printed *)
  conditions : (int * witness option) list;  (** 1 to 7: [None] for a condition that holds *)
}

val check : Polyhedron.ifs -> t
(** The results of all seven conditions for a set. Near linear in the size of the set. *)

val holds : t -> bool
(** [holds t] is true if all seven conditions hold. *)

val euler : t -> int
(** |V| - |dg(F)| + |F| with unordered edges. *)

val euler_ordered : t -> int
(** |V| - |dg(F)| + |F| with ordered pairs for edges: a closed surface counts each edge twice. *)

val statement : int -> string
(** [statement k] is the text of condition k, 1 to 7, in a few words. *)

val explain : t -> vertex:(int -> string) -> face:(int -> string) -> witness -> string
(** [explain t ~vertex ~face w] is the reason why a condition fails, with the names of vertices and faces. *)
