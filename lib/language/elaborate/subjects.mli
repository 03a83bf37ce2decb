(** What formulas speak of: leaves by name, channels, and the ranges of quantifiers. Each function reports what
    it does not find, and returns [None] then. *)

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
  law_budget : Typed.budget;  (** for what may be parts of laws, though no law uses it *)
}

val create : Context.t -> Bodies.t -> Composition.t -> Behaviours.t -> t

val error :
  t ->
  ?hint:string ->
  ?near:string * (unit -> string list) ->
  Code.t ->
  Span.t ->
  ('a, unit, string, unit) format4 ->
  'a
(** As {!Report.error}. *)

val leaf : t -> Env.t -> Ast.expr -> int option
(** The index in the model of the one leaf that the expression names. *)

val spot : t -> Env.t -> Ast.expr -> Property.spot option
(** A leaf, or a part of one, as in [arm.tip]. *)

val channel : t -> Ast.expr -> (Behaviour.polarity option * string) option
(** [a] or [~a]. *)

val bond_name : t -> Env.t -> Ast.expr -> string option
(** [a], the plain name that bonds bear. *)

val owner : t -> int -> Behaviours.owner option
(** A leaf of the model as an owner of behaviours. *)

val range : t -> Env.t -> Ast.expr -> int list option
(** The leaves that a quantifier over a template, process or family ranges over; those that are not in the
    network are
    negative. A family of templates stands for all of its instances. *)
