(** The connections of the faces of an indexed face set along their edges (E1, E2), without regard to
    positions. Faces are tuples of vertex indices in range, of at least three entries. *)

type t
(** The directed edges of the faces. *)

val make : int -> int array array -> t
(** [make vertex_count faces] has the directed edges of the faces. Linear time. *)

val edge_faults : t -> Polyhedron_fault.t list
(** The faults against E1 and E2; empty iff both hold. If edges are repeated only since some faces run the other
    way round than their neighbours, these faces are returned ([Turned_face]), and otherwise each repeated edge.
    Each edge without its reverse is returned as well, unless it is repeated. In the order of the faces. *)

val across : t -> int -> int -> int * int
(** [across s v w], when E1 and E2 hold, is the face that runs from [w] to [v], and the place of [w] in its
    tuple. It is the neighbour of the face that runs from [v] to [w]. *)

val pieces : t -> int list
(** The first face of each set of faces that is connected through edges. E1 and E2 hold. *)

val edges : t -> (int * int) array
(** The unordered edges (reading I-1), the smaller index first, in lexicographic order. *)

val unordered_count : t -> int
(** |dg(F)| with unordered edges. *)

val ordered_count : t -> int
(** |dg(F)| as printed, with ordered pairs. *)

val unordered : t -> ((int * int) * (int * bool) list) list
(** Each unordered edge [v, w] with [v < w], in lexicographic order. It comes with its faces, in increasing
    order, and true for those that run from [v] to [w]. A face comes as often as it has the edge. *)
