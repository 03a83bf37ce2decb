(** A formula about a model that somebody writes beside it: a number, a state predicate or a temporal formula. *)

open Scc_base
open Scc_syntax
open Scc_property

type t = State of Property.prop | Number of Property.num | Temporal of Property.check

(** {1 Of a loaded model} *)

val all : Loaded.t -> Source.t list -> (Loaded.t * t list, Diag.t list) result
(** What the formulas are, and the model in which they have their meaning: that one has them as its last checks,
    and keeps in its states what they speak of (the time, for one). Its runs are those of the model, with the same
    labels in the same order. *)

(** {1 By who loads models in another way} *)

(** As what a formula is looked at: what a check takes, a state predicate, a number. *)
type form

val name : form -> string
(** Tells the forms apart. *)

val item : form -> Ast.expr -> Ast.item
(** The check to add to a model. *)

val ask : model:('m -> Loaded.t) -> (form -> ('m, Diag.t list) result) -> ('m * t, Diag.t list) result
(** Given how to load the model with the {!item} of a form as its last one: the formula, and the model with it. *)
