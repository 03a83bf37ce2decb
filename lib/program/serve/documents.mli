(** The documents that are shown, each in a process of its own. Only so many are kept: a new one takes the place of
    that which nobody has asked for the longest time. *)

open Scc_exchange

type t
type document

val create : unit -> t

val opened : t -> string array -> text:string -> string option
(** Starts the process with these arguments, and gives it the text: the name of the document, or none where so many
    are being made that there is no room. *)

val find : t -> string -> document option

val status : document -> seconds:float -> Json.t Lwt.t
(** As it is when something is new, or after so many seconds. *)

val is_ready : document -> bool

val interrupt : document -> unit
(** One that is being made ends with what it has. *)

val ask : document -> string -> (string, Child.failure) result Lwt.t
val close : t -> document -> unit Lwt.t
val close_all : t -> unit Lwt.t
