(** Explorations, and lists of runs, on disk: a folder with one SQLite database, in which each of them has its
    blocks ({!Scc_parallel.Log}), one transaction for each.

    A block is there as a whole or not at all, and is there for good once {!Scc_parallel.Log.t.keep} has returned:
    the write-ahead log is synchronised with each transaction. Each block has a digest of itself and of all before
    it, so that what is read is what was written, in its order. *)

open Scc_base

type t

val openly : string -> identity:(string * string) list -> warn:(Diag.t -> unit) -> (t, Diag.t) result
(** The store in a folder, which is made if it is not there. [identity]: of what it keeps explorations, by names
    and values: all must be those that it was made with. It is this process's alone until it ends. One that
    cannot be written to is read, and keeps nothing more. The error: the folder cannot be made, read or written,
    is no store, or another process has it (SC0910); it keeps something
    else, and what differs (SC0911); it is damaged (SC0912). All blocks have been looked at. [warn] is told
    once when blocks are not kept any more (SC0103). *)

val folder : t -> string

val log : t -> string -> Scc_parallel.Log.t
(** Of the exploration of this name. A name that comes again in one run is that of another one: those come in the
    same order in each run. When a block cannot be kept, this and all later ones are not, and {!failed} tells. *)

val resumed : t -> bool
(** It had blocks when it was opened. *)

val failed : t -> Diag.t option
(** Why blocks are not kept any more, if so: an output that cannot be written (SC0103), or a store that has been
    damaged since it was opened (SC0912). *)

val close : t -> unit
