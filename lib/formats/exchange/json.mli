(** JSON as scc writes and reads it. Writing is deterministic: members keep the order in which they are
    given, and there are no floats (a bug otherwise). *)

open Scc_base
open Scc_exact

type t = Yojson.Basic.t

(** {1 Writing} *)

val text : string -> t
(** A string; bytes that are not UTF-8 become U+FFFD, so that what is written is always JSON. *)

val rat : Rat.t -> t
(** A string ["p/q"] in lowest terms, with q > 0 written even when it is 1. *)

val vec : Vec.t -> t
(** An array of three rationals. *)

val option : ('a -> t) -> 'a option -> t
(** [null] for [None]. *)

val line : t -> string
(** On one line, without its end. *)

val pretty : t -> string
(** Over several lines where it is long, ended by a newline. *)

(** {1 Reading} *)

val parse : Source.t -> (t, Diag.t) result
(** The whole text as one value (SC0801 otherwise). Values nested deeper than 200 are refused. *)

val parse_line : Source.t -> start:int -> stop:int -> (t, Diag.t) result
(** The same for a piece of the text, given by offsets. *)

val member : string -> t -> t option
(** [None] also for what is no object and for [null]. *)

val string : t -> string option
val int : t -> int option
val list : t -> t list option

val rational : t -> Rat.t option
(** Of a string [p/q], a decimal string or a JSON integer. *)
