(** A report on an indexed face set as a template: both verdicts, kept apart (reading I-2), sizes and mass
    properties. *)


type verdict =
  | Accepted of Polyhedron.t * Mass_properties.t  (** a convex closed polyhedron: E0 to E5 hold *)
  | Rejected of Polyhedron_fault.t list  (** not empty, the most telling first *)

type t = {
  set : Polyhedron.ifs;
  edges : int;  (** unordered *)
  verdict : verdict;
  paper : Definition_4_3.t;  (** the conditions as printed *)
}

val make : Polyhedron.ifs -> t
(** The report on a set: its check by {!Polyhedron.of_ifs}, the conditions of Definition 4.3, and its mass
    properties. *)

val accepted : t -> bool
(** [accepted r] is true if the set is a convex closed polyhedron. *)

val vertex_name : t -> int -> string
(** The name of the vertex with this index in the set. *)

val face_name : t -> int -> string
(** The name of the face with this index in the set. *)

val faults : t -> Scc_base.Diag.t list
(** One diagnostic without a place for each fault, in their order. For an accepted set it is the warning SC0312
    if the centroid of an accepted set is not the origin of body space, else the list is empty. *)

val max_faults : int
(** The number of faults that a text lists, 20; the others are only counted. *)

val names : (string * 'a) array -> string
(** The names of vertices or faces, in order, separated by commas. Beyond 40, the rest is only counted;
    ["none"] for no name. *)

val to_text : name:string -> t -> string
(** Several lines for readers, the last ended by a newline. *)
