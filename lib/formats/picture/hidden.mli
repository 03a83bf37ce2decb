(** What is seen of faces and edges when others are in front of them. Exact: a face is in front of another one
    where its depth is greater, which is decided by integers; floats only choose who is asked. The solids may
    touch, and they may even cross; where two faces of one plane cover each other the first of them is seen. *)

open Scc_exact

type t

val make : View.t -> t
val view : t -> View.t

val pieces : t -> int -> Convex.t list
(** What is seen of a face of the view, in disjoint pieces. *)

val all_pieces : t -> Convex.t list array

val segments : t -> View.edge -> (Ivec.t * Ivec.t) list
(** What is seen of an edge, in order: the parts along which a face of it is seen. *)

val uncovered : t -> Ivec.t * Rat.t -> Ivec.t * Rat.t -> (Ivec.t * Ivec.t) list
(** The parts of a segment, from a point of the picture at a depth to another one, that no face is in front of;
    sides of faces are in front of nothing. *)

val shows : t -> Ivec.t -> depth:Rat.t -> bool
(** Whether no face is in front of a point of the picture at a depth. *)

val front : t -> Ivec.t -> int option
(** The face that is seen at a point of the picture, which is on no side of a face. *)
