(** A formula about a model that is given apart from it: a number, a state predicate or a temporal formula. *)

open Scc_base
open Scc_syntax
open Scc_property

type t = State of Property.prop | Number of Property.num | Temporal of Property.check

(** {1 Of a loaded model} *)

val all : Loaded.t -> Source.t list -> (Loaded.t * t list, Diag.t list) result
(** The formulas, and the model in which they have their meaning. That model has them as its last checks, and
    its states contain what the formulas mention (the time, for one). Its runs are those of the given model,
    with the same labels in the same order. *)

(** {1 For other ways of loading models} *)

(** The form in which a formula is tried: a formula of a check, a state predicate, or a number. *)
type form

val name : form -> string
(** A name that distinguishes the forms: ["check"], ["state"] or ["number"]. *)

val item : form -> Ast.expr -> Ast.item
(** [item form e] is the check to add to a model. *)

val ask : model:('m -> Loaded.t) -> (form -> ('m, Diag.t list) result) -> ('m * t, Diag.t list) result
(** [ask ~model load] is the formula, and the model with it. [load form] loads the model with the {!item} of a
    form as its last one. The forms are tried in order; errors are those of the first. *)
