(** Numbers and lists of words in the attributes of SVG. *)

open Scc_exact

exception Bad of string
(** What is wrong with an attribute. *)

exception Unread of string
(** What it says, and scc does not read. *)

type cursor = { text : string; mutable at : int }

val skip : cursor -> unit
(** Blanks and commas. *)

val ended : cursor -> bool
(** After blanks and commas. *)

val number : cursor -> Rat.t
(** The next one, exactly, after blanks and commas: of at most 40 characters and 10{^±9}. *)

val flag : cursor -> bool
(** The next one of 0 and 1, which need not be parted from what follows. *)

val all : string -> Rat.t list
(** At most a million. *)

val length : string -> Rat.t
(** One number with a unit: in pixels, of which 96 are an inch. *)
