(** Explorations, and lists of runs, on disk: a folder with one SQLite database, in which each of them has its
    blocks ({!Scc_parallel.Log}), one transaction for each.

    A block is stored as a whole or not at all. It is durable once {!Scc_parallel.Log.t.keep} has returned, as
    the write-ahead log is synchronised with each transaction. Each block has a digest of itself and of all
    blocks before it. So what is read is what was written, in its order. *)

open Scc_base

type t

val openly : string -> identity:(string * string) list -> warn:(Diag.t -> unit) -> (t, Diag.t) result
(** [openly folder ~identity ~warn] opens the store in [folder]. A folder that does not exist is made. [identity]
    is the names and values that identify the model and the options; a store must have been made with the same
    ones. A store that can be written to is locked for this process until it ends. Any other is read, and keeps
    no new blocks. All blocks are checked against their digests. The errors are:
    - SC0910: the folder cannot be made, read or written, for want of a permission or as something else is there;
      it is no store; or it is locked by another process;
    - SC0911: the store is of another version or identity, and the message has the difference;
    - SC0912: the store is damaged.

    Where there is no room to write, the store has {!failed} from the beginning, and keeps nothing. Where there are
    too few descriptors, it raises [Unix.Unix_error]. [warn] is called once, when the store ceases to keep blocks
    (SC0103 or SC0912). *)

val folder : t -> string
(** The path of the store's folder. *)

val log : t -> string -> Scc_parallel.Log.t
(** [log t name] is the log of the exploration of this name. The second call with one name is the log of a second
    exploration, and so on: explorations of one name come in the same order in each run. After a block that
    cannot be kept, no later blocks are kept, and {!failed} has the reason. *)

val failed : t -> Diag.t option
(** Why the store keeps no more blocks, if so: an output that cannot be written (SC0103), or damage since it was
    opened (SC0912). *)

val close : t -> unit
(** Closes the database of the store. *)
