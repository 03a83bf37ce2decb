(** The declarations of a model with loops expanded and scopes attached, in order: the input of later passes.
    Values and templates are settled here, since they may be used only after their declaration. Behaviours and
    bodies may be used anywhere. *)

open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type body = {
  env : Env.t;
  name : Ast.segment;
  first : Ast.leaf;
  rest : (Ast.bond * Ast.leaf) list;
  fixed : bool;
}

type behaviour = {
  env : Env.t;
  name : Ast.name;
  label : string;  (** its key ({!Family.val-head}) *)
  formals : Ast.name list;
  definitions : Ast.definitions;
  on : Ast.reference option;
  body : Ast.behaviour;
  mutable used : bool;
}

type check = {
  env : Env.t;
  name : string;  (** with the values of the loops around it: [safe[2]] *)
  span : Span.t;
  formula : Ast.expr;
  written : Ast.expr -> string;  (** a part of it as a text, with the values of the loops around it *)
}

type motion = { env : Env.t; target : Ast.path option; law : Ast.law; at : Span.t }

type t = {
  name : string option;
  overrides : Overrides.t;
  parameters : (string * Rat.t) list;  (** those with a value *)
  ranges : Ranges.t;  (** those of the other parameters, in order *)
  shapes : string list;  (** names of shapes and compounds in order *)
  timestep : Rat.t;
  steps : Model.steps;
  splits : Model.splits;
  settings : Settings.t;  (** of rigid motion *)
  families : Repeated.t;
  empty : Empty.t;
  bodies : body list;
  bonds : (Env.t * Ast.bond) list;
  behaviours : (string, behaviour) Hashtbl.t;
  network : (Env.t * Ast.path list * Span.t) option;
  motions : motion list;
  checks : check list;
  values : (string * string * Env.binding) list;  (** parameters and [let]s: what, name, binding *)
  last : Env.t;  (** at the end of the text *)
}

val read :
  Context.t ->
  overrides:(string * Rat.t) list ->
  narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  ?parametric:Asked.given ->
  Ast.model ->
  t option
(** Reads the declarations of a model. It is [None] if loops make more than {!Limits.items} declarations, which
    is reported (SC0111). *)

val check_after : t -> Ast.name -> Ast.expr -> check
(** [check_after t name formula] is the check that would stand at the end of the text. *)
