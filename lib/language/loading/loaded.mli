(** Models that are ready for use: the start of every command and every request. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_property
open Scc_semantics

type t = {
  source : Source.t;
  origin : Origin.t;
  semantics : Semantics.t;  (** with a cache of its own *)
  model : Model.t;
  declared : State.t;
  (** as declared: before {!Scc_semantics} sets clocks and steers; at simple values of parameters with ranges *)
  uncertain : Uncertain.t option;  (** where parameters have ranges ([Model.ranges]): the numbers that depend
                                       on them *)
  parameter : Open_number.t option;  (** the parameter that is asked about (rule Parametric) *)
  checks : Property.check list;
  premises : Property.check list;
  (** The premises of the checks, each with the name of its check: a check whose premise never comes true is
      vacuous. They are decided beside the checks, and prolong no exploration. A check is never decided before
      its premise has been met or all is explored. *)
  families : Scc_elaborate.Repeated.t;  (** those of loops, be they empty or not *)
  lattices : Scc_elaborate.Lattices.t list;  (** of the bodies that diffuse *)
  warnings : Diag.t list;
  values : (Span.t * string) list;  (** as {!Scc_elaborate.Elaborate.t} has them *)
  at_values : (string * Rat.t) list -> (t, Diag.t list) result;  (** see {!at} *)
  beside : Scc_syntax.Ast.model -> (t, Diag.t list) result;  (** see {!with_checks} *)
}

type reader = string -> (string, string) result
(** A function from the path of a mesh, as written in the model, to its bytes. The error says why it cannot be
    read. *)

val load :
  read_file:reader ->
  overrides:(string * Rat.t) list ->
  ?narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  ?parametric:Scc_elaborate.Asked.given ->
  Source.t ->
  (t, Diag.t list) result
(** The model of a text, in its notation ({!Scc_notation.Notation.of_source}). Parameters have the values of
    [overrides]. Parameters with ranges have those of [narrowed] if they are listed there. [parametric] is a
    parameter of weights and chances of which functions are wanted. *)

val of_tree :
  read_file:reader ->
  overrides:(string * Rat.t) list ->
  ?narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  ?parametric:Scc_elaborate.Asked.given ->
  Source.t ->
  Scc_syntax.Ast.model ->
  (t, Diag.t list) result
(** The model of a syntax tree of the text. The tree may have more items than the text. *)

val at : t -> (string * Rat.t) list -> (t, Diag.t list) result
(** [at l values] is the model with these values for parameters as well. It has no ranges if all parameters
    with ranges are among them. The errors say why there is no such model, as SC0217 for a value out of its
    range. *)

val with_checks : t -> Scc_syntax.Ast.model -> (t, Diag.t list) result
(** [with_checks l items] is the model with these items, which are checks, after those of its text
    ({!Scc_elaborate.Elaborate.with_checks}). *)

val initial : t -> (State.t, Diag.t list) result
(** The initial state. It is an error if a law of motion has no value there. *)
