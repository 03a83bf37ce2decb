(** Where states came up that another process found: for the last of many. *)

type t

val create : unit -> t

val put : t -> int -> worker:int -> answer:int -> step:int -> unit
(** Of a state, by its number: the places of the answer and of the step that led to it (see {!Answered}). *)

val find : t -> int -> worker:int -> (int * int) option
(** The answer and the step, if that process found the state. *)
