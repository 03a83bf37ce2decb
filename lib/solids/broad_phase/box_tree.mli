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

val move : t -> int -> Float_box.t -> unit
(** [move t key box] is [remove t key] and then [insert t key box]. It is quicker where the new box is near to the
    old one. *)

val mem : t -> int -> bool
(** [mem t key] is true if the set has a box under this key >= 0. *)

val iter_meeting : t -> Float_box.t -> (int -> unit) -> unit
(** [iter_meeting t box f] calls [f] for the key of each box that [Float_box.meet]s [box], once each. The
    order depends on earlier insertions and removals. [f] must not change the tree. *)

val iter_meeting_own : t -> int -> (int -> unit) -> unit
(** [iter_meeting_own t key f] is [iter_meeting t box f] for the box of a key that is in [t] (a bug otherwise). It
    calls [f] for [key], too. *)

val height : t -> int
(** The greatest number of nodes between a root and a leaf; for tests. *)

val is_sound : t -> bool
(** [is_sound t] is true if each node has the least box around its children and is in balance; for tests. *)
