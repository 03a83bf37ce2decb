(** Timed CTL by the definition, on points and open intervals with a clock beside: slow, and shares nothing with
    the evaluator but the syntax. *)

open Scc_ctl

type t

val make : Small.t -> t

(** Whether it holds for certain, and whether it may hold. *)
type answer = { surely : bool; perhaps : bool }

val node : t -> Formula.t -> int -> answer
val cell : t -> Formula.t -> int -> int -> answer
(** In a cell of the flow of a node. *)
