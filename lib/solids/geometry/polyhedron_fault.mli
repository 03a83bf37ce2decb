(** What is wrong with an indexed face set, with the witness. Numbers are indices into the set. *)

type t =
  | No_faces
  | Flat of int  (** E0: no vertex is strictly behind this face *)
  | Bad_vertex_index of int * int  (** face, index that is out of range *)
  | Short_face of int  (** fewer than three corners *)
  | Open_edge of int * int * int  (** E2: face; its directed edge v, w has no reverse *)
  | Repeated_edge of int * int * int * int  (** E1: the directed edge v, w occurs in both these faces *)
  | Turned_face of int * int array
  (** E1: the face runs the other way round than its neighbours; its corners in the right order *)
  | Same_position of int * int  (** E3: two vertices *)
  | Unused_vertex of int  (** E3 *)
  | Off_plane of int * int  (** E4: face, vertex off the plane of its other corners *)
  | Degenerate_face of int * int  (** E4: face, vertex at which it does not turn left strictly *)
  | Self_crossing of int * int array option
  (** E4: a face whose sides cross or that winds more than once; its corners in the right order, where only the
      order is wrong *)
  | Not_convex of int * int  (** E5: face, vertex strictly in front of it *)
  | Coplanar_neighbours of int * int  (** E5: two faces of one plane that share an edge *)
  | In_plane of int * int  (** E5: face, vertex of other faces only in its plane *)
  | Inward  (** the faces are oriented clockwise *)
  | Separate_solids of int * int  (** a face of each of two solids that share no edge *)

val kind : t -> string
(** The name of the constructor in lower case, with hyphens: ["open-edge"], …. It is stable, for use by
    programs. *)

val code : t -> Scc_base.Code.t
(** The diagnostic code of a fault. *)

val message : vertex:(int -> string) -> face:(int -> string) -> t -> string
(** One sentence for readers, without the final full stop, with the names of vertices and faces. *)

val hint : vertex:(int -> string) -> face:(int -> string) -> t -> string option
(** Advice how to repair the fault, where that is clear. *)
