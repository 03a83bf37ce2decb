(** What can be written at a place of a text: the names that fit there, and words with their grammar. *)

(** Something that can be written. *)
type offer = {
  name : string;  (** what is written *)
  kind : string;
  (** ["channel"], ["feature"], ["body"], ["shape"], ["behaviour"], ["value"], ["module"], ["word"], … *)
  form : string option;
  (** of a word: how it is used, with names in capitals for what is to be put in; of a family: as it is declared *)
  about : string option;  (** of a word: what it means *)
}

val at : Known.t -> string -> int -> int * offer list
(** [at known text offset] is where the word begins that is being written, and what fits there and begins alike,
    the likeliest first. [known] are the names of the text, perhaps of how it was a moment ago. Nothing fits
    within a comment or a text in quotation marks. *)

val import : string -> int -> (int * [ `File of string | `Library ]) option
(** Within what an import names: where that begins, and whether it is a file, by what is written of its path, or a
    module of the library. *)
