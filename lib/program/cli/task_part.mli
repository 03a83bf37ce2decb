(** One of several parts of a list of tasks, so that the parts can be done separately, on many machines, for
    example. *)

open Cmdliner

(** A part K of N. *)
type t

val range : t option -> count:int -> int * int
(** The first task of this part of [count] tasks, which are numbered from 0, and the task after its last.
    Without a part it is all tasks. The parts have every task once, in order, and their sizes differ by at most
    one. *)

val option : what:string -> t option Term.t
(** The option [--part K/N]; [what] names the tasks. *)
