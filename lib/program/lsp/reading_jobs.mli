(** Documents are read when their text has not changed for a moment: each in a process of its own, which the next
    change ends. *)

(** The documents that are read, or are to be. *)
type t

val create :
  Session.t -> found:(Workspace.document -> Analysis.t -> unit) -> say:(string -> unit) -> t
(** No document is read. [found] is called with results, [say] with what the user should know. *)

val later : t -> Workspace.document -> unit
(** The document has changed: it and those that import it are read again, a moment from now. *)

val changed_file : t -> string -> unit
(** The file at a path has changed: the documents that import it are read again. *)

val forget : t -> Workspace.document -> unit
(** The document was closed. Those that import it are read again. *)

val jobs : t -> Job.t list
(** The processes at work. *)

val wait : t -> float
(** The seconds until something is to be done; negative if nothing is. *)

val go_on : t -> unit
(** Starts what is due, and ends what takes too long. *)

val close : t -> unit
(** Ends all processes. *)
