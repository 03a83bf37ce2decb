(** The original Shape Calculus (Table 1 of the paper, left column) as a notation of models: specs/original.md. *)

open Scc_base
open Scc_syntax

val read : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result
(** The model in the language of [lib/language/syntax], by {!Refine}, whose notes are among the comments. *)

val write : Ast.model * Trivia.t list -> (string, Diag.t list) result
(** A model of the language, by {!Abstract}. *)

val canonical : Source.t -> (string, Diag.t list) result
(** The same model in canonical layout, its regions as they were written; SC0360 for what is none. *)

val readable : Source.t -> Ast.model
(** What can be read of a text that may be full of faults, without its regions that are no features. *)
