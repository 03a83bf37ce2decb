(** What the names of a text stand for, so that all places of one name can be found: for references, definitions
    and renaming. *)

open Scc_base
open Scc_describe

(** What a name stands for. *)
type target =
  | Here of int  (** a declaration of this text, or a family; by the offset of its first name *)
  | Several of int list  (** one of these declarations: the text does not tell which *)
  | Channel of string
  | There of { library : bool; file : string; name : string }
  (** what an import brings, by its name in the file as written; [""] for the module itself *)

(** A place of a name. *)
type occurrence = {
  at : Span.t;
  target : target;
  declares : bool;  (** the name is declared here; a channel: open as its name or its co-name *)
}

val same : target -> target -> bool
(** [same a b] is true if the two are one declaration, channel or import. *)

val all : Reading.t -> occurrence list
(** All names of a text that have a target, in the order of the text. *)

val at : Reading.t -> int -> occurrence option
(** The occurrence that contains an offset or ends there. *)

val exported_target : Reading.t -> string -> target option
(** What a text declares under a name that an import can bring, within its own text. *)
