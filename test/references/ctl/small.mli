(** Small timed graphs in which everything happens at multiples of one unit of time. *)

open Scc_ctl
open Scc_exact

type truth = F | T | U

(** Cell 2k of a flow is the open interval (k, k + 1), cell 2k + 1 the instant k + 1. *)
type flow =
  | No_flow
  | Lasts of int * int list  (** 2d - 1 cells *)
  | Ray of int  (** 2k + 1 cells; the last goes on for ever *)

type node = {
  at : truth array;  (** by predicate *)
  cells : truth array array;  (** by predicate, along the flow *)
  edges : int list;
  drawn : bool;  (** which of the edges is left to chance: 1 part to the first, 2 to the second, … *)
  others : int;  (** where it is: so many of the last edges are choices of their own, but not the first edge *)
  flow : flow;
  known : bool;  (** what follows a node that is not known is there all the same: one way it could be *)
}

type t = { nodes : node array; unit : Rat.t }

val graph : t -> Timed_graph.t
val predicates : t -> Eval.predicates
val evaluator : ?effort:Scc_chance.Effort.t -> t -> Eval.t

val cells : node -> int
(** Of its flow. *)

val chances : node -> Rat.t list
(** Of its edges that are drawn, when some are. *)

val split : node -> 'a list -> 'a list * 'a list
(** What stands for edges, in order: the part that is drawn, when some are, and the others. *)

val cell : truth array -> int -> truth
(** The last one stands for all that come after it. *)

val offset : t -> int -> Algebraic.t
(** An offset in a cell. *)

(** {1 Random ones} *)

val count : int
(** Predicates. *)

val gen : unsure:bool -> truncated:bool -> t QCheck2.Gen.t

val complete : t -> t QCheck2.Gen.t
(** The same where it is known, and anything elsewhere. *)

val formula_gen : Rat.t -> int -> Timed_formula.t QCheck2.Gen.t
(** With bounds that are multiples of the unit, nested as deep as this. *)

val print : t -> string
val print_formula : Timed_formula.t -> string
