(** A mutable set of boxes with queries for those that meet a box. It is a tree in which the box of each node
    contains the boxes below it. Inserting and removing take O(log n) steps. A query takes about as many, and
    some for each box found, as long as the boxes do not overlap each other much. *)

open Scc_geometry

type t

val create : unit -> t
(** A new set without boxes. *)

val insert : t -> int -> Float_box.t -> unit
(** [insert t key box] adds a box under a key >= 0 that is not in [t] (a bug otherwise). Memory is proportional
    to the greatest key. *)

val remove : t -> int -> unit
(** [remove t key] removes the box of a key that is in [t] (a bug otherwise). *)

val move : t -> (int * Float_box.t) list -> unit
(** [move t moves] is [remove t key] and then [insert t key box] for each pair, a key and its new box: one batch,
    whose keys differ. It is quicker where new boxes are near to the old ones, and where they are many. *)

val iter_moved_pairs : t -> (int -> int -> unit) -> unit
(** [iter_moved_pairs t f] calls [f] for each two boxes that meet, of which the last {!move} has moved
    one or both. It does so once for each pair, in an order that depends on the tree. Since the batch, the set must
    not have been changed. [f] must not change it either. *)

val mem : t -> int -> bool
(** [mem t key] is true if the set has a box under this key >= 0. *)

val iter_meeting : t -> Float_box.t -> (int -> unit) -> unit
(** [iter_meeting t box f] calls [f] for the key of each box that [Float_box.meet]s [box], once each. The
    order depends on earlier insertions and removals. [f] must not change the tree. *)

val height : t -> int
(** The greatest number of nodes between a root and a leaf; for tests. *)

val is_sound : t -> bool
(** [is_sound t] is true if each node has the least box around its children and is in balance; for tests. *)
