(** Models that are ready to be worked on: what every command and every request starts from. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_property
open Scc_semantics

type t = {
  source : Source.t;
  origin : Origin.t;
  semantics : Semantics.t;  (** with a memory of its own *)
  model : Model.t;
  declared : State.t;
  (** as declared: before {!Scc_semantics} sets clocks and steers; at simple values of parameters with ranges *)
  uncertain : Uncertain.t option;  (** where parameters have ranges ({!Model.ranges}): what depends on them *)
  checks : Property.check list;
  premises : Property.check list;
  (** What has to come true for the checks to say anything, each with the name of its check: to be decided beside
      them. They keep no exploration going, as a check is never decided before its premise has been met or all is
      explored. *)
  warnings : Diag.t list;
  again : Scc_syntax.Ast.model -> (string * Rat.t) list -> (t, Diag.t list) result;
  (** see {!at} and {!with_items} *)
}

type reader = string -> (string, string) result
(** Given the path of a mesh as the model writes it: its bytes, or why it cannot be read. *)

val load :
  read_file:reader ->
  overrides:(string * Rat.t) list ->
  ?narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  Source.t ->
  (t, Diag.t list) result
(** In the notation of the text ({!Scc_notation.Notation.of_source}), with the values of [overrides] for
    parameters, and the ranges of [narrowed] for those that have ranges. *)

val of_tree :
  read_file:reader ->
  overrides:(string * Rat.t) list ->
  ?narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  Source.t ->
  Scc_syntax.Ast.model ->
  (t, Diag.t list) result
(** Of a syntax tree that the text was read into, perhaps with more in it than the text says. *)

val at : t -> (string * Rat.t) list -> (t, Diag.t list) result
(** The same model where parameters have these values as well: of one point, if all that have ranges are among
    them. The error is why there is no such model, a value out of its range (SC0217) for one. *)

val with_items : t -> Scc_syntax.Ast.model -> (t, Diag.t list) result
(** The same model with more in it than its text says, after all else. *)

val initial : t -> (State.t, Diag.t list) result
(** The initial state. The error is why a law of motion has no value there. *)
