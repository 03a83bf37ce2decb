(** What is kept of one exploration while it goes on, in blocks of bytes, for another process to go on from. *)

type t = {
  next : unit -> string option;
  (** the next of the blocks that were kept before; [None] after the last, and from then on *)
  keep : string -> unit;
  (** a block more, after the last: when it returns, it is kept, whatever happens to this process or its machine *)
}

val none : t
(** Keeps nothing. *)

val in_memory : string list -> t * (unit -> string list)
(** With some blocks to begin with; and all that are kept by now, in order. *)
