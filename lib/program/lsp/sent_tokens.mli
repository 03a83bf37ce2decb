(** The semantic tokens of the last answers for each document, so that the next answer can be a difference. *)

type t

val create : unit -> t
(** [create ()] knows no answer. *)

val find : t -> uri:string -> string -> int array Lazy.t option
(** [find t ~uri id] is the tokens of the answer with this id for a document, in the encoding of LSP 3.17: five
    integers for each. Only the last two answers of a document are kept. *)

val add : t -> uri:string -> int array Lazy.t -> string
(** [add t ~uri tokens] keeps the tokens of an answer. The result is its id, which no other answer of the session
    has. *)

val forget : t -> string -> unit
(** [forget t uri] drops the answers for a document that was closed. *)

val difference : int array -> int array -> (int * int * int array) option
(** [difference before after] is an edit from the integers [before] to [after]: where it starts, how many
    integers it deletes there, and those that it inserts. It is [None] if they are equal. Each token is kept or
    replaced as a whole. *)
