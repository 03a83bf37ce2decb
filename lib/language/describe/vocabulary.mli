(** The words of the language with a line on the meaning of each. Not all are reserved: the place of a word
    decides whether it is one of these or a name. *)

(** The kind of place at which a word has its meaning. *)
type category =
  | Word  (** a word of the language *)
  | Setting  (** a value of a setting: [free_body] *)
  | Solid  (** a shape that needs no declaration: [box] *)
  | Function  (** of numbers and vectors: [min] *)
  | Component  (** of a vector *)
  | Atom  (** of a formula: [distance2] *)
  | Law  (** a variable of laws of motion: [dt] *)
  | Event  (** a transition: [event bind] *)
  | Measure  (** a word before a bracket: [Pmax] *)

(** A word with its meaning. *)
type entry = {
  category : category;
  word : string;
  kind : string;  (** for programs: ["keyword"], ["setting"], ["quantity"], … *)
  section : string;  (** of [specs/language.md] *)
  meaning : string;
}

val all : entry list
(** All words, by category. A word may have entries in several categories. *)

val find : category -> string -> entry option
(** The entry of a word in a category. *)
