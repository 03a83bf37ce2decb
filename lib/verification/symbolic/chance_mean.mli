(** A mean over the runs as a function of the parameters (rules Starts and Expectation). *)

open Scc_polyhedra

(** Which of the schedulers, and which end where something is not known. *)
type mode = { choice : [ `Least | `Greatest ]; unknown : [ `Least | `Greatest ] }

val solve :
  ?most:int -> progress:(sets:int -> all:int -> unit) -> Chance_graph.t -> mode -> parameters:int -> Affine.t
(** [solve ?most ~progress t mode ~parameters] is the mean that the question of [t] wants, as a function of the
    starts, which are values of so many parameters. A mean until something is infinite where a run may never come
    to it. At its least end an unknown state is one where the run has come to it, and at its greatest end one from
    which it never does. A number at a time is unknown where the number has no value, or where an unknown state may
    be reached before. What follows the first [most] layers is unknown. *)
