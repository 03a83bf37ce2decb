(** The beginning of a connection between two owners: each shows the other that it belongs to the same
    exploration and knows the secret. The secret itself is not sent. Each side sends a nonce, and then a keyed
    digest (HMAC with SHA-256) of both greetings. What follows is neither encrypted nor signed. *)

(** What an owner says of itself. *)
type self = {
  number : int;  (** from 0 *)
  count : int;
  program : string;  (** the version of scc *)
  identity : string;  (** what is explored, with the options *)
  secret : string;
}

(** A greeting that is under way. *)
type talk

val talk : self -> ?expected:int -> Unix.file_descr -> talk
(** [talk self ~expected fd] begins on a socket that is connected. [expected] is the owner that was called;
    without it, the other side has called. Raises {!Failure.Failed}. *)

val hear : self -> talk -> wanted:(int -> bool) -> bool
(** [hear self t ~wanted] reads what has come. It is true once the other side has shown who it is. [wanted] is
    true for the owners that may still come. Raises {!Failure.Failed} if the other side is none of them. *)

val peer : talk -> int
(** The number of the other owner, once {!hear} was true. *)
