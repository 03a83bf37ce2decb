(** From the syntax tree of a model to the terms of the calculus: names, loops, templates, properties, and
    every static check (rule WellFormed). *)

open Scc_base
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_property

type t = {
  name : string option;  (** from [model NAME] *)
  parameters : (string * Rat.t) list;  (** with their values in this run, in order *)
  templates : (string * Polyhedron.t) list;  (** in order of declaration *)
  model : Model.t;
  declared : State.t;
  (** as declared: before {!Scc_semantics} sets clocks and steers. Where parameters have ranges, at simple numbers
      within them, with {!Behaviour.Wait} in behaviours *)
  uncertain : Uncertain.t option;  (** where parameters have ranges ({!Model.ranges}): what depends on them *)
  checks : Property.check list;
  premises : Property.check list;
  (** what has to come true for the checks to say anything ({!Premises}), each with the name of its check *)
  warnings : Diag.t list;
}

val elaborate :
  read_file:(string -> (string, string) result) ->
  overrides:(string * Rat.t) list ->
  ?narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  Scc_syntax.Ast.model ->
  (t, Diag.t list) result
(** [read_file] is given the path of a mesh as written (the caller resolves it relative to the model) and
    returns its bytes or why it cannot be read. [overrides] are the values given by [-D], and [narrowed] the
    ranges. Errors are sorted; as many as make sense are reported at once. *)
