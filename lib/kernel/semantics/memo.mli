(** Queries of the rules that a caller may cache. Each field takes the function that computes the answer, and
    returns that answer; {!none} calls the function each time. No answer may depend on the state of a cache. The
    rules keep nothing: a cache is made elsewhere ([Scc_engine.Process_cache]) and passed to {!Semantics.make}.
*)

open Scc_calculus

(** The outcomes of a collision of two processes, or why the model has none. *)
type collision = (Transition.outcome list, Transition.fault) result

type t = {
  parts : int -> State.process -> (unit -> Part.t list) -> Part.t list;
  (** the parts of the process with this index in the network *)
  urgent : State.process -> (unit -> Transition.outcome list) -> Transition.outcome list;
  (** what a process must do by itself: strong splits, closings *)
  weak : State.process -> (unit -> Transition.outcome list) -> Transition.outcome list;
  (** what a process may do by itself: weak splits *)
  contact : Part.t -> Part.t -> (unit -> Kinematics.contact) -> Kinematics.contact;
  (** how two parts stand to each other *)
  collision : State.process -> State.process -> (unit -> collision) -> collision;
  (** the collision of two processes that are a cluster by themselves ({!Collisions.clusters}) *)
  renewed : unit -> t;  (** an empty cache, for another model *)
}

val none : t
(** The memo without a cache: each query is computed. *)
