(** A set of boxes that changes, and the question which of them meet a box: a tree of boxes in which each node
    holds those below it. Inserting and removing take O(log n) steps; a query takes about as many, and some for
    each box that it finds, as long as the boxes do not overlap each other much. *)

open Scc_geometry

type t

val create : unit -> t

val insert : t -> int -> Float_box.t -> unit
(** [insert t key box], for a key >= 0 that is not in [t] (a bug otherwise). Memory is proportional to the
    greatest key. *)

val remove : t -> int -> unit
(** For a key that is in [t] (a bug otherwise). *)

val mem : t -> int -> bool

val iter_meeting : t -> Float_box.t -> (int -> unit) -> unit
(** The keys of all boxes that {!Float_box.meet} the given one, each once, in an order that depends on what was
    inserted and removed before. The function must not change the tree. *)

val height : t -> int
(** The greatest number of nodes between a root and a leaf; for tests. *)

val is_sound : t -> bool
(** Every node is as large as what is below it, and in balance; for tests. *)
