(** Small timed graphs with the truth of a goal written on every instant and interval of them, as an
    abstract transition system and, unrolled cell by cell, as the naive answer to every question. *)

open Scc_ctl

type truth = F | T | U

type edge = {
  target : int;
  duration : int;
  cells : truth array;  (** strictly inside: (0, 1), 1, (1, 2), 2, …, (d - 1, d) *)
}

type ahead = Edges of edge list | Ray of truth array  (** the last for ever *) | Dead_end
type node = { at : truth; ahead : ahead }

type t = node array
(** State 0 is the initial one. *)

module System :
  Scc_graph_search.Lts.S
  with type context = t
   and type fault = unit

val truth : truth -> Truth.t
val timeline : t -> int -> Timeline.extent -> Truth.t Timeline.t
val rests : t -> int -> bool
val gen : t QCheck2.Gen.t
val print : t -> string

val possibly : t -> within:int option -> unsure:bool -> bool
(** EF; [unsure] is what U counts as. *)

type inevitable = Yes | No | Zeno

val inevitable : t -> within:int option -> unsure:bool -> inevitable
(** AF. *)
