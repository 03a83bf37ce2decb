(** What has been found out about single processes, and about two, for those that were asked about last. A network
    that takes a step leaves most of its processes alone, and what they do by themselves depends on nobody else:
    where the parts of a process are, what it must and may do alone, whether parts of two are in contact and what
    comes of it when the two collide. No answer depends on what is remembered.

    Processes are told by where they are in memory, so that a process that is made anew is a new one. *)

open Scc_calculus

type t

val none : t
(** Nothing is remembered. *)

val create : unit -> t

val renewed : t -> t
(** For another model: empty, and [none] for [none]. *)

type together = (Transition.outcome list, Transition.fault) result

(** {1 Questions}

    Each with the answer, if it is not known. *)

val parts : t -> int -> State.process -> (unit -> Part.t list) -> Part.t list
(** With the place of the process in the network. *)

val urgent : t -> State.process -> (unit -> Transition.outcome list) -> Transition.outcome list
val weak : t -> State.process -> (unit -> Transition.outcome list) -> Transition.outcome list
val contact : t -> Part.t -> Part.t -> (unit -> Kinematics.contact) -> Kinematics.contact

val together : t -> State.process -> State.process -> (unit -> together) -> together
(** Two that collide, each with the other alone. *)
