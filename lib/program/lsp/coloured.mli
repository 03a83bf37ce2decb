(** What words of documents were sent as, so that the next answer can be what has changed. *)

type t

val create : unit -> t
(** Nothing was sent. *)

val find : t -> uri:string -> string -> int array Lazy.t option
(** What was sent for a document under an id. Only the last few are known. *)

val add : t -> uri:string -> int array Lazy.t -> string
(** The id of what is sent now; no other answer of the session has it. *)

val forget : t -> string -> unit
(** The document of this address was closed. *)

val difference : int array -> int array -> (int * int * int array) option
(** [difference before after] is the place, the number of integers that are taken away there, and those that are
    put there. It is [None] if nothing has changed. Words, of five integers each, stay whole. *)
