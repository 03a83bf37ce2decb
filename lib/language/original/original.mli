(** The original Shape Calculus (Table 1 of the paper, left column) as a notation of models: specs/original.md. *)

open Scc_base
open Scc_syntax

val read : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result
(** Reads a model of the original notation into the language of [lib/language/syntax], by {!To_refined}. The notes
    of {!To_refined} are among the comments. *)

val as_written : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result
(** The declarations and comments of a text, for their places. Regions are names that hold them ({!Tree}). *)

val write : Ast.model * Trivia.t list -> (string, Diag.t list) result
(** Writes a model of the language in the original notation, by {!Abstract}. *)

val canonical : Source.t -> (string, Diag.t list) result
(** Reads a text and writes it in canonical layout, with its regions as they were written. An expression that is
    no region is SC0360. *)

val readable : Source.t -> Ast.model
(** Reads what can be read of a text with errors. Regions that are no single feature are left out. *)
