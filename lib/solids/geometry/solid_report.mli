(** All that there is to say about an indexed face set as a template: both verdicts, kept apart (reading
    I-2), sizes and mass properties. *)

open Scc_exact

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
val accepted : t -> bool

val off_centre : t -> Vec.t option
(** The centroid of an accepted set, when it is not the origin of body space: the paper wants it there, and
    nothing here depends on it. *)

val vertex_name : t -> int -> string
val face_name : t -> int -> string

val faults : t -> Scc_base.Diag.t list
(** One diagnostic without a place for each fault, in their order, or the warning SC0312 when {!off_centre}
    gives an offset. *)

val max_faults : int
(** So many faults are listed in text; then how many more there are. *)

val names : (string * 'a) array -> string
(** Of vertices or faces, in order; of many the first, and how many more there are. *)

val to_text : name:string -> t -> string
(** Several lines for a person, the last ended by a newline. *)
