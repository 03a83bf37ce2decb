(** What stands at a place of a text, for people who look at it in an editor. The text need not be a model yet:
    declarations that cannot be read are passed over, and nothing is worked out. *)

open Scc_base

type t = {
  at : Span.t;
  kind : string;  (** ["process"], ["channel"], ["keyword"], … *)
  name : string;
  text : string;  (** a line that says what it is, and perhaps more: its declaration, or where it is explained *)
  declared : Span.t option;  (** the name where it is declared; of what a module declares, its import *)
}

val find : read_module:(library:bool -> string -> string option) -> Source.t -> int -> t option
(** At the offset of a byte: within a name or a word, or right after one. [read_module] gives the texts of what is
    imported, if they are there. Given a text alone, it is read once for all offsets. *)
