(** The declaration at a place of a text as words, for completion: it may be half written, so it is looked at
    word by word. *)

open Scc_base
open Scc_syntax

(** The words around the place, without the one that is being written, and the declarations that begin there. *)
type t = private {
  words : string array;  (** as written in ASCII; texts in quotation marks are left out *)
  count : int;  (** how many of them stand before the place *)
  items : item list;  (** in the order of the text *)
}

(** The beginning of a declaration, and what belongs to it. *)
and item = { word : string; name : string; first : int; stop : int  (** the word after the last one *) }

val is_name : string -> bool
(** [is_name w] is true for names and words of the language, and false for marks and numbers. *)

val window : string -> int -> int * Source.t * Tokens.t
(** The declaration at an offset of a text, perhaps with some before it: where it begins, its text, and its tokens
    with places in that text. *)

val around : string -> int -> (int * t) option
(** [around text offset] is where the word begins that is being written at the offset, and what stands around it.
    It is [None] within a comment or a text in quotation marks. *)

val here : t -> item option
(** The declaration that contains the place. *)

val before : t -> int -> string
(** [before t k] is the word [k] words before the place, from 1; [""] if there is none, or if it belongs to another
    declaration. *)

val bracket : t -> int option
(** The innermost bracket, within the declaration, that is open at the place: its index. *)
