(** The notations in which models are written. Each is read into the syntax tree of [lib/language/syntax], with the
    places of its own texts, and all that comes after is the same for every one of them; and each is written from
    such a tree. *)

open Scc_base
open Scc_syntax

type t = {
  name : string;  (** what the command line calls it *)
  told : string;  (** what it is, in a few words *)
  extensions : string list;  (** of its files, with the dot *)
  read : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result;  (** with the comments *)
  write : Ast.model * Trivia.t list -> (string, Diag.t list) result;
  (** in canonical layout, the comments kept; the error is what the notation cannot say *)
  canonical : Source.t -> (string, Diag.t list) result;
  (** what was read in canonical layout; where reading loses nothing, what {!write} gives of it *)
  readable : Source.t -> Ast.model;  (** what can be read of a text that may be full of faults *)
}

val shape_calculus : t
(** The language of [specs/language.md]. *)

val bioshape : t
(** XML: [specs/bioshape-xml.md]. *)

val original : t
(** The original calculus: [specs/original.md]. *)

val all : t list
(** The table: another notation is another line of it. *)

val of_source : Source.t -> t
(** By the extension of its name; without any that is known, by how the text begins. What is nothing else is in the
    language of [specs/language.md]. *)

val of_name : string -> t option
(** By the extension of the name of a file. *)

val model : Source.t -> (Ast.model, Diag.t list) result
(** A whole model, in the notation of {!of_source}. *)

val readable : Source.t -> Ast.model
(** What can be read of a text that may be full of faults, as the notation does it. *)

val canonical : Source.t -> (string, Diag.t list) result
(** The same model in canonical layout and in its own notation. *)
