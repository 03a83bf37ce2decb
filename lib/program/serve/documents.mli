(** The open documents, each in a process of its own. At most 12 are kept: a new one replaces the one that has
    been unused for the longest time. *)

open Scc_json

(** All open documents. *)
type t

(** An open document. *)
type document

val create : unit -> t
(** No documents. *)

val opened : t -> string array -> text:string -> string option
(** Starts a process with these arguments and sends it the text. The result is the name of the document. It is
    [None] if so many documents are being made that there is no room. *)

val find : t -> string -> document option
(** The document with this name, which counts as used now. *)

val status : document -> seconds:float -> Json.t Lwt.t
(** The state of a document, as soon as it changes, or after [seconds]. *)

val is_ready : document -> bool
(** [is_ready d] is true if the document is made and can be viewed. *)

val interrupt : document -> unit
(** Interrupts the process of a document that is being made, which then ends with its results so far. *)

val ask : document -> string -> (string, Child.failure) result Lwt.t
(** The answer of a document to a line. Without an answer within 75 seconds, its process is ended. *)

val close : t -> document -> unit Lwt.t
(** Closes a document and ends its process. *)

val close_all : t -> unit Lwt.t
(** Closes all documents. *)
