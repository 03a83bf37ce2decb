(** The places in workers' answers where new states came up first. A table has the last 32768 of them, at the
    number of the state modulo its size. *)

type t

val create : unit -> t
(** An empty table. *)

val put : t -> int -> worker:int -> answer:int -> step:int -> unit
(** [put t state ~worker ~answer ~step] records where the state with number [state] came up: in an answer of
    [worker], by the places of the answer and of the step that leads to it ({!Answered}). *)

val find : t -> int -> worker:int -> (int * int) option
(** [find t state ~worker] is the places of the answer and of the step, if the state came up in an answer of
    [worker]; else [None]. *)
