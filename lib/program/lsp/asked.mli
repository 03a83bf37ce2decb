(** Questions about large documents, each answered in a process of its own, so that the next keystroke need not
    wait. A change of the document ends them. *)

open Scc_json

(** The questions that wait for answers. *)
type t

val create : send:(string -> unit) -> t
(** No questions. [send] sends the text of a message to the client. *)

val ask : t -> id:Json.t -> uri:string -> (unit -> Json.t) -> unit
(** [ask t ~id ~uri work] answers a request by [work ()], which is called in another process and may raise
    {!Rpc.Refused}. A few processes work at a time; the others wait. *)

val changed : t -> string -> unit
(** The document of this address has changed: questions about it are answered by an error of the protocol. *)

val cancel : t -> Json.t -> bool
(** Cancels the request with this id; false if it is not among the questions. *)

val jobs : t -> Job.t list
(** The processes at work. *)

val go_on : t -> unit
(** Starts what waits, as far as there is room. *)

val close : t -> unit
(** Ends all of them. *)
