(** Questions of the rules whose answers a caller may keep. Each field takes the function that works the answer
    out, and returns that answer; {!none} calls it each time. No answer may depend on what is kept. The rules keep
    nothing: a cache is made elsewhere ([Scc_engine.Process_cache]) and handed to {!Semantics.make}. *)

open Scc_calculus

(** What becomes of two processes that collide, or why the model has no answer. *)
type collision = (Transition.outcome list, Transition.fault) result

type t = {
  parts : int -> State.process -> (unit -> Part.t list) -> Part.t list;
  (** the parts of a process, which has this place in the network *)
  urgent : State.process -> (unit -> Transition.outcome list) -> Transition.outcome list;
  (** what a process must do by itself: strong splits, closings *)
  weak : State.process -> (unit -> Transition.outcome list) -> Transition.outcome list;
  (** what a process may do by itself: weak splits *)
  contact : Part.t -> Part.t -> (unit -> Kinematics.contact) -> Kinematics.contact;
  (** how two parts stand to each other *)
  collision : State.process -> State.process -> (unit -> collision) -> collision;
  (** two processes that collide with each other and with no third *)
  renewed : unit -> t;  (** an empty one, for another model *)
}

val none : t
(** Keeps nothing. *)
