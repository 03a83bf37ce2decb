(** From the syntax tree of a model to the terms of the calculus: names, loops, templates, properties, and all
    static checks (rule WellFormed). *)

open Scc_base
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_property

type t = {
  name : string option;  (** from [model NAME] *)
  parameters : (string * Rat.t) list;  (** with their values in this run, in order *)
  templates : (string * Polyhedron.t) list;  (** in order of declaration *)
  families : Repeated.t;  (** those of loops, be they empty or not *)
  model : Model.t;
  declared : State.t;
  (** as declared, before [Scc_semantics] sets clocks and steers. Parameters with ranges have simple numbers
      within them, and behaviours have {!Scc_calculus.Behaviour.Wait} *)
  uncertain : Uncertain.t option;  (** all that depends on the parameters with ranges ([Model.ranges]) *)
  parameter : Open_number.t option;  (** the parameter of [parametric] *)
  checks : Property.check list;
  premises : Property.check list;
  (** the premises without which checks hold vacuously ({!Premises}), each with the name of its check *)
  lattices : Lattices.t list;  (** of the bodies that diffuse *)
  warnings : Diag.t list;
  values : (Span.t * string) list;
  (** the exact values of parameters and of lets that have one by themselves, each with the place of its name. A
      name within a loop has several. *)
  kept : kept;  (** for {!with_checks} *)
}

and kept
(** What formulas that are read later need of the elaboration. *)

val elaborate :
  read_file:(string -> (string, string) result) ->
  overrides:(string * Rat.t) list ->
  ?narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  ?parametric:Asked.given ->
  Scc_syntax.Ast.model ->
  (t, Diag.t list) result
(** Elaborates a model. [read_file] returns the bytes of a mesh by its path as written, or why it cannot be
    read; the caller resolves the path relative to the model. [overrides] are the values of [-D], and [narrowed]
    the ranges. [parametric] is a parameter of weights and chances of which functions are wanted (rule Parametric).

    Errors are sorted. As many as make sense are reported at once. *)

val with_checks : t -> Scc_syntax.Ast.model -> (t, Diag.t list) result
(** [with_checks t items] is what {!elaborate} makes of the same model with [items], which are checks, at its
    end; so are its errors. Only the checks are read, unless they compare with behaviours that the model does not
    have by itself: then all of the model is elaborated again. *)
