(** The blocks of bytes that one exploration keeps, for another process to continue it. *)

type t = {
  next : unit -> string option;
  (** the next of the blocks that an earlier run kept; [None] after the last one *)
  keep : string -> unit;
  (** keeps one more block behind the last; when it returns, the block outlives this process and a failure of its
      machine *)
}

val none : t
(** The log that has no blocks and keeps none. *)
