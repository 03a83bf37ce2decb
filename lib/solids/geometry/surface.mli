(** How the faces of an indexed face set hang together along their edges (E1, E2), without regard to
    positions. Faces are tuples of vertex indices in range, of at least three entries. *)

type t
(** The directed edges of the faces. *)

val make : int -> int array array -> t
(** [make vertex_count faces]. Linear. *)

val edge_faults : t -> Polyhedron_fault.t list
(** Empty iff E1 and E2 hold. When all that is wrong is that some faces run the other way round than their
    neighbours, these faces ([Turned_face]); otherwise each repeated edge and each edge without its reverse
    (an edge that is repeated is not also reported as open). In the order of the faces. *)

val across : t -> int -> int -> int * int
(** [across s v w], when E1 and E2 hold: the face that runs from [w] to [v], the neighbour of the one that
    runs from [v] to [w], and the place of [w] in its tuple. *)

val pieces : t -> int list
(** When E1 and E2 hold: the first face of each set of faces that is connected through edges. *)

val edges : t -> (int * int) array
(** The unordered edges (reading I-1), the smaller index first, in lexicographic order. *)

val unordered_count : t -> int
(** |dg(F)| with unordered edges. *)

val ordered_count : t -> int
(** |dg(F)| as printed, with ordered pairs. *)

val unordered : t -> ((int * int) * (int * bool) list) list
(** Each unordered edge [v, w] with [v < w], in lexicographic order, with the faces that have it, in
    increasing order, and whether they run from [v] to [w]; a face comes as often as it has the edge. *)
