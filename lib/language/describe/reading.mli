(** A text with what is read of it. Each part is computed when it is first needed, once. *)

open Scc_base
open Scc_syntax

(** A text. *)
type t = private {
  source : Source.t;
  tokens : Tokens.t Lazy.t;
  model : Ast.model Lazy.t;  (** what can be read of it *)
  uses : Uses.t Lazy.t;  (** its names *)
}

val make : Source.t -> t
(** The text of a source. *)

val is_plain : Source.t -> bool
(** [is_plain source] is true if the text is in the language of [specs/language.md], and in no other notation. *)

val tokens_at : Tokens.t -> int -> int list
(** The indices of the token that contains an offset and of the one that ends there. *)
