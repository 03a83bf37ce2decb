(** What a model chooses, each at most once: [collisions], [binding] and [bonds] (readings I-32, I-33 and I-37),
    and the settings of rigid motion, [dynamics], [resolution] and [round] (rules Turn and Round). *)

open Scc_base
open Scc_syntax
open Scc_calculus

type t

val create : unit -> t
val dynamics : t -> Report.t -> Ast.name -> unit
val read_collisions : t -> Report.t -> Ast.name -> unit
val read_binding : t -> Report.t -> Ast.name -> unit
val read_bonds : t -> Report.t -> Ast.name -> unit
val resolution : t -> Report.t -> Env.t -> Ast.expr -> unit

val round : t -> Report.t -> Env.t -> Ast.name -> Ast.expr -> unit
(** Of [orientation] or [velocity], to multiples of 2^-k with k > 0. *)

val rigid : t -> Report.t -> spinning:(string * Span.t) option -> Model.leaf array -> Model.rigid option
(** Of the network of these bodies, of which one is given a spin or none: some iff one is (with a warning where
    no [dynamics] is given, SC0215) or [dynamics] is given; otherwise the settings that are given have no
    effect (SC0213). A resolution of more than an eighth of the shortest edge is coarse (SC0214). Where no
    resolution is given it is the greatest power of two that is at most 2^-20 times the least edge. *)

val collisions : t -> Model.collisions
(** [In_turn] if nothing is said. *)

val round_velocity : t -> int option
(** k, of 2^-k. *)

val binding : t -> Model.binding
(** [On_collision] if nothing is said. *)

val bonds : t -> Model.bonds
(** [Acyclic] if nothing is said. *)

val check : t -> Report.t -> spins:bool -> unit
(** A rigid model cannot choose [On_contact] (SC0901). *)
