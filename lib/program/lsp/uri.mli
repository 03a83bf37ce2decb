(** Addresses of documents, and paths of files. *)

val path : string -> string option
(** The path of an address [file:///…] of this machine, without [.] and [..]; [None] for any other address. *)

val of_path : string -> string
(** The address of an absolute path. *)

val name : string -> string
(** What a document is called in messages: its path, or its whole address. *)

val normal : string -> string
(** A path without [.], [..] and doubled slashes. *)
