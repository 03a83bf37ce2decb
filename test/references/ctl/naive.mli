(** Timed CTL by the definition, on points and open intervals with a clock beside: slow, and shares nothing with
    the evaluator but the syntax. *)

open Scc_ctl

(** Steps of a run. Times are counted in halves of the unit. Who starts at an offset inside an open interval is
    put into the middle of it: at a [Middle], with the second half of the interval to come. *)
type place =
  | Node of int
  | Whole of int * int  (** a cell of a flow: an instant, or the interval from its beginning on *)
  | Middle of int * int
  | Half of int * int

type step = {
  place : place;
  length : int;  (** 0 for what is one instant *)
  jumps : int list;  (** by edges *)
  passes : int list;  (** by the passing of time *)
  hidden : bool;
}

(** Whether it holds for certain, and whether it may hold. *)
type answer = { surely : bool; perhaps : bool }

type t = {
  small : Small.t;
  steps : step array;
  numbers : (place, int) Hashtbl.t;
  mutable known : (Timed_formula.t * answer array) list;  (** by step *)
}

val make : Small.t -> t

val value : t -> Timed_formula.t -> answer array
val low : answer array -> bool array
val high : answer array -> bool array

val node : t -> Timed_formula.t -> int -> answer
val cell : t -> Timed_formula.t -> int -> int -> answer
(** In a cell of the flow of a node. *)
