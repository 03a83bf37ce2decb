(** One of several parts of a list of tasks, so that they can be worked on apart: on many machines, say. *)

open Cmdliner

type t

val range : t option -> count:int -> int * int
(** The first of this part of so many tasks, numbered from 0 on, and the one after its last; without one, all. The
    parts have every task once, in order, and as many as each other, or one less. *)

val option : what:string -> t option Term.t
(** [--part K/N]; [what] there are parts of. *)
