(** How declarations, settings and calls are written, by the table [forms.txt]. *)

(** What a form is for. *)
type category =
  | Written
  (** a declaration, a setting, an attribute or a part of a behaviour; names in capitals stand for others *)
  | Called  (** a function, an atom, a solid or a law: its name with its arguments *)
  | Event  (** a transition after the word [event] *)
  | Choice  (** the values of a setting *)

(** A word with its forms. *)
type entry = { category : category; word : string; forms : string list }

val all : entry list
(** The table, in its order. *)

val find : category -> string -> string list option
(** The forms of a word in a category. *)
