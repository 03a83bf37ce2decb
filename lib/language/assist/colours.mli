(** What each word of a text is, so that editors can colour it by its meaning. *)

open Scc_describe

(** The kind of a word. *)
type kind =
  | Keyword
  | Comment
  | Text
  | Number
  | Module
  | Template
  | Behaviour
  | Body
  | Value
  | Argument
  | Feature
  | Channel
  | Function
  | Choice  (** the value of a setting, or another word that is not reserved *)

(** A word at its place, by offsets. *)
type word = { start : int; stop : int; kind : kind; declares : bool }

val of_text : Reading.t -> word list
(** The words of a text, in its order. Marks and names without a meaning are left out. *)
