(** All owners, as one of them sees them: messages to each, and rounds in which all say something to all. *)

type t

val make :
  number:int ->
  links:Link.t option array ->
  each:(int -> char -> string -> unit) ->
  from_parent:(unit -> unit) ->
  t
(** [make ~number ~links ~each ~from_parent] is the view of the owner [number]. [each peer kind text] is called
    for each message of another owner, and must not wait for others. [from_parent] is called if standard input
    can be read. *)

val number : t -> int
(** The number of this owner, from 0. *)

val count : t -> int
(** The number of owners. *)

val others : t -> int list
(** The numbers of the other owners, in order. *)

val pump : t -> float -> unit
(** [pump m seconds] waits for at most so long (for ever, if it is negative) until something can be read or
    written, and reads and writes it. *)

val post : t -> int -> char -> string -> unit
(** [post m peer kind text] sends a message, of any kind but ['p'] and ['P']. It never waits. *)

val send : t -> int -> char -> string -> unit
(** [send m peer kind text] is {!post}. If much waits for this owner, it works on what the others send until less
    does. So no owner keeps more than 5 MiB for another one, and no two owners wait for each other. *)

val let_go : t -> unit
(** From now on another owner may end: its connection is dropped. *)

val gather : t -> (int -> string) -> string array
(** [gather m text] says [text peer] to each owner, and waits until each of them has said something in this
    round. The result is what they have said, in order, with [text number] of this one. All messages that an
    owner has sent before the round have come when it ends. *)

val messages : t -> int
(** How many messages have been sent. *)

val bytes : t -> int
(** How many bytes they have. *)

val sums : t -> int list -> int list
(** [sums m numbers] is a round in which all owners give as many numbers, not below 0: the sums. *)
