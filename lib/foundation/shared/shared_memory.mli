(** Memory that a process shares with those that it forks afterwards. It needs no file, and takes room where it
    has been written to; where nothing was written there are zeros.
    Under a limit on addresses ([ulimit -v]) the system counts all of it: there is none then. *)

open Bigarray

type numbers = (int, int_elt, c_layout) Array1.t
type halves = (int32, int32_elt, c_layout) Array1.t
type bytes = (int, int8_unsigned_elt, c_layout) Array1.t

val numbers : int -> numbers option
(** [numbers count] is memory for [count] numbers; [None] if the system refuses so much. *)

val many_numbers : unit -> numbers option
(** [many_numbers ()] is memory for 2{^31} numbers, or for a smaller power of two, at least 2{^20}, as many as
    the system gives. *)

val halves : int -> halves option
(** [halves count] is memory for [count] numbers of 32 bits; [None] if the system refuses so much. *)

val bytes : int -> bytes option
(** [bytes count] is memory for [count] bytes; [None] if the system refuses so much. *)

val all : 'a option list -> 'a list option
(** [all list] is all of them; [None] if the system has refused one. *)

(** {1 What happens at one instant}

    An index is in range (a bug otherwise). A process that sees what one of them has
    written also sees what its process wrote before. *)

val exchange : halves -> int -> from:int -> into:int -> bool
(** [exchange memory i ~from ~into] writes [into] at index [i] if [from] is there. It is false if something else
    was there. Both numbers have 32 bits with a sign. *)

val write_half : halves -> int -> int -> unit
(** [write_half memory i number] writes a number of 32 bits at index [i]. *)

val add : numbers -> int -> int -> int
(** [add memory i more] adds [more] to the number at index [i], and is the number that was there before. *)

val read : numbers -> int -> int
(** [read memory i] is the number at index [i], as the last {!write} or {!add} of any process has left it. *)

val write : numbers -> int -> int -> unit
(** [write memory i number] writes a number at index [i]. *)

val raise_to : numbers -> int -> int -> unit
(** [raise_to memory i number] makes the number at index [i] [number], unless it is greater. *)

val swap : numbers -> int -> int -> int
(** [swap memory i number] writes a number at index [i], and is the number that was there before. All processes
    see it between what this process has written before and what it reads afterwards. *)
