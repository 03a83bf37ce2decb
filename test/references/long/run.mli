(** The run of the long test: groups of cases that share two bodies. *)

type plan = {
  random : int;  (** at least so many cases of each *)
  degenerate : int;
  seed : int;
  only : int option;  (** one group *)
  hulls : int list;  (** the sizes of the larger shapes *)
}

type report = {
  counts : ((string * string) * int) list;  (** by kind and outcome, in order *)
  by_chance : int;
  constructed : int;
  groups : int;
  checked_slowly : int;
  differences : string list;  (** each with all that is needed to see it again; a run stops at the tenth *)
}

val run : ?progress:(int -> unit) -> plan -> report
(** [progress] is told the number of cases that are done, now and then. *)

val print : report -> unit
(** A table. *)
