(** The meaning of the word at a place of a text, for editors. The text need not be a model yet: declarations
    that cannot be read are skipped, and nothing is computed. *)

open Scc_base

(** The meaning of a name or word. *)
type t = {
  at : Span.t;
  kind : string;  (** ["process"], ["channel"], ["keyword"], … *)
  name : string;
  text : string;  (** a line that describes it, perhaps with its declaration or the section on it *)
  declared : Span.t option;  (** the place of its name in its declaration, or of the import of its module *)
}

val at : read_module:(library:bool -> string -> string option) -> Reading.t -> int -> t option
(** [at ~read_module reading offset] describes the name or word that contains the offset of a byte or ends there.
    [read_module] returns the texts of imports, if there are any. *)

val find : read_module:(library:bool -> string -> string option) -> Source.t -> int -> t option
(** [find ~read_module source] is {!at} of the text of a source, which is read once for all offsets. *)
