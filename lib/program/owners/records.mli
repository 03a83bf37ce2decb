(** States that owners send each other: how each was found, and its difference from the one that was sent before.
    What occurs in several states is sent once, and then by a number ({!Scc_parallel.Wire}). *)

open Scc_codec

(** Both directions of a connection to another owner. *)
type t

val make : Part.t -> t
(** A connection over which nothing has been sent. *)

val put : t -> time:int -> instant:int -> before:int -> choice:int -> int array -> unit
(** [put r ~time ~instant ~before ~choice state] adds a state of the other owner to the text that is to be sent.
    [time] and [instant] are as for {!Part.enter}. *)

val size : t -> int
(** The length of the text that is to be sent. *)

val take : t -> string
(** The text that is to be sent, which is empty from then on. *)

(** A state that was sent, and the transition by which it was found. *)
type arrow = { id : int; before : int; choice : int }

val read : t -> Part.t -> sender:int -> string -> (arrow -> unit) -> unit
(** [read r part ~sender text each] enters the states of a text of {!take} that came from the owner [sender], and
    calls [each] for them. The texts must be read in the order in which they were taken. Raises {!Failure.Failed}
    for other texts. *)

val read_one : t -> Part.t -> sender:int -> Packed.source -> arrow
(** [read_one r part ~sender source] enters the next state of such a text. Raises [Packed.Malformed], [Failure] or
    [Invalid_argument] for other bytes. *)
