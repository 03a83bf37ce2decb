(** Many states at once, in columns of numbers, for programs that need more speed than texts allow. The format
    is [specs/successors.md]. *)

open Scc_base

(** A filter with the labels and transitions of its last answer. *)
type t

val make : Filter.t -> t
(** A batch filter; the other side knows no labels yet. *)

val most : int
(** The greatest length of a frame: 2^30 bytes. *)

val answer : t -> string -> Buffer.t -> (unit, Diag.t) result
(** [answer t frame out] writes to [out] the frame, with its length, that answers [frame], which has none. A
    frame that does not fit its format is SC0921, and nothing is written. *)
