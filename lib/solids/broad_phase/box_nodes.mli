(** The nodes of the trees of {!Box_tree}, and the shape of the trees: balance, and nodes that are small.

    A node has two children, on the sides 0 and 1. A child is a node again (its number, from 0) or a leaf
    (-1 - its key). A node keeps the boxes of its children. The box of a node is the least one around them. Nodes
    below {!heads} are heads: the one child of a head, on side 0, is the root of a tree. *)

open Scc_geometry

type t

val create : unit -> t
(** No leaves. *)

val heads : int
(** The number of heads. *)

val is_head : int -> bool
(** [is_head i] is true if the node [i] is a head. *)

val child : t -> int -> int -> int
(** [child t i side] is a child of the node [i]. *)

val side_of : t -> int -> int -> int
(** [side_of t i c] is the side of the child [c] of the node [i]. *)

val leaf_parent : t -> int -> int
(** [leaf_parent t key] is the parent of a leaf, or -1 if there is no leaf with this key >= 0. *)

val is_free : t -> int -> bool
(** [is_free t i] is true if the node [i] belongs to no tree at present. *)

val height : t -> int -> int
(** The height of a child: 0 for a leaf, and one more than the greater height of its children for a node. *)

(** {1 Boxes} *)

val bounds : int -> int -> int
(** [bounds i side] is where the box of that child of the node [i] is kept. *)

val new_box : int
(** Where the box is kept for which a place is looked for. *)

val set_box : t -> int -> Float_box.t -> unit
(** [set_box t at box] keeps [box] at [at]. *)

val copy_box : t -> from:int -> int -> unit
(** [copy_box t ~from at] keeps the box that is at [from] at [at], too. *)

val meet : t -> int -> int -> bool
(** [meet t i j] is true if the boxes at these two places have a common point. *)

val meets : t -> int -> Float_box.t -> bool
(** [meets t at box] is true if the box at a place and [box] have a common point. *)

val greatest_length : float
(** Greater lengths count as this one, infinite ones as well. *)

(** {1 Leaves}

    Each of these restores the balance and the boxes of all nodes, but for {!put} and {!cut_off}. *)

val make_room : t -> int -> unit
(** [make_room t key] allows for leaves up to this key. *)

val put : t -> int -> int -> int -> from:int -> unit
(** [put t i side c ~from] makes [c], whose box is at [from], a child of the node [i]. *)

val cut_off : t -> int -> unit
(** [cut_off t key] takes away the leaf that is the only one below its head. *)

val find_place : t -> int -> int -> (int -> int -> unit) -> unit
(** [find_place t i side k] calls [k] with the node and the side of the best sibling for a leaf with the box at
    {!new_box}. It looks downwards from the child of [i] on that side, wherever nodes grow least. *)

val place_above : t -> int -> (int -> int -> unit) -> unit
(** [place_above t i k] calls [k] with the parent and the side of the first node from [i] upwards whose box
    contains that at {!new_box}, or else of a root. *)

val insert : t -> int -> int -> int -> unit
(** [insert t key i side] makes a new leaf, with the box at {!new_box}, the sibling of that child of [i]. *)

val remove : t -> int -> int
(** [remove t key] takes a leaf away that has a sibling. The result is the node that had been above its parent. *)

val refit : t -> int -> unit
(** [refit t i] restores the balance and the boxes of the nodes from [i] upwards, after the box of a child of [i]
    or its height has changed. *)

(** {1 Marks}

    A mark is a number > 0 for some leaves and for all nodes above them. A later one is greater, and replaces an
    earlier one. *)

val set_mark : t -> int -> int -> unit
(** [set_mark t mark key] marks a leaf. *)

val has_mark : t -> int -> int -> bool
(** [has_mark t mark c] is true of a leaf if it has that mark, and of a node if one below it has. It may be true of
    some other nodes too. *)

val refit_marked : t -> int -> int -> unit
(** [refit_marked t mark i] brings the boxes of the node [i] and of all marked nodes below it up to date, where
    leaves with this mark have other boxes than before. *)

val is_sound : t -> int -> bool
(** [is_sound t i] is true if each node below [i] has the least box around its children and is in balance; for
    tests. *)
