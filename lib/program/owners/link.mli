(** A connection to another owner, after the greeting ({!Greeting}): messages in both directions, in order. A
    message is its length in four bytes, the least first, a byte for its kind, and a text. Neither side ever
    waits here. *)

type t

val most : int
(** The greatest length of the text of a message: 2{^20} bytes. *)

val make : peer:int -> Unix.file_descr -> t
(** [make ~peer fd] is a connection to the owner [peer], from 0. *)

val peer : t -> int
(** The number of the other owner, from 0. *)

val descriptor : t -> Unix.file_descr
(** The socket, for [select]. *)

val post : t -> char -> string -> unit
(** [post l kind text] appends a message, and writes as much as the socket takes. Raises {!Failure.Failed} if the
    connection has ended, as do the other functions. *)

val waiting : t -> int
(** How many bytes have been posted that the socket has not taken. *)

val flush : t -> unit
(** Writes as much as the socket takes. *)

val receive : t -> (char -> string -> unit) -> unit
(** [receive l each] reads once from the socket, and calls [each] for each message that is whole. *)
