(** What the tests of the front end share. *)

open Scc_base
open Scc_syntax

val source : string -> Source.t
(** A text named [m.sc]. *)

val parsed : string -> Ast.model
(** Fails the test, showing the diagnostics, when the text is refused. *)

val parsed_expr : string -> Ast.expr

val errors : string -> Diag.t list
(** Fails the test when the text is accepted. *)

val rendered : string -> Diag.t list -> string
(** Diagnostics as a person sees them. *)

val summary : string -> Diag.t list -> string list
(** ["SC0110 2:7"] for each. *)

val contains : string -> string -> bool
(** [contains text part]. *)
