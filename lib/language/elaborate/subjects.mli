(** The subjects of formulas: leaves by name, channels, and the ranges of quantifiers. Each function reports
    what it cannot find and then returns [None]. *)

open Scc_base
open Scc_syntax
open Scc_calculus
open Scc_property

type t = {
  c : Context.t;
  bodies : Bodies.t;
  composition : Composition.t;
  behaviours : Behaviours.t;
  by_template : (string, int list) Hashtbl.t;  (** indices in the model, in order *)
  numbers : int array;  (** the declared number of each leaf of the model *)
  budget : Typed.budget;
  law_budget : Typed.budget;  (** for expressions that no law uses but that may be parts of laws *)
}

val create : Context.t -> Bodies.t -> Composition.t -> Behaviours.t -> t
(** The subjects of a network, with full budgets of terms. *)

val copy : t -> Context.t -> t
(** [copy t c] has the subjects of [t], with behaviours ({!Behaviours.copy}) and budgets of its own. It reports to
    [c]. *)

val error :
  t ->
  ?hint:string ->
  ?near:string * (unit -> string list) ->
  Code.t ->
  Span.t ->
  ('a, unit, string, unit) format4 ->
  'a
(** Reports an error as {!Report.error} does. *)

val leaf : t -> Env.t -> Ast.expr -> int option
(** The index in the model of the one leaf that the expression names. A name of several bodies, or of one
    outside the network, is SC0210. *)

val spot : t -> Env.t -> Ast.expr -> Property.spot option
(** A leaf, or a part of one, as in [arm.tip]. *)

val reference_of : Ast.expr -> Ast.reference option
(** An expression as a reference to a declaration: [K], [m.K], [K[1, 2]] or [K(a)]. *)

val channel : t -> Ast.expr -> (Behaviour.polarity option * string) option
(** A channel by its name [a], without polarity, or by its co-name [~a]. *)

val bond_name : t -> Env.t -> Ast.expr -> string option
(** The plain name [a] of the channel of a bond. *)

val owner : t -> int -> Behaviours.owner option
(** [owner t i] is the leaf with the index [i] in the model as an owner of behaviours. *)

val range : t -> Env.t -> Ast.expr -> int list option
(** The leaves of a quantifier over a template, process or family, as indices in the model. Leaves outside the
    network are negative. A family of templates stands for all of its instances. *)
